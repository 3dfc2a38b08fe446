/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// ITK's own filters before ours: an image of nuclei is smoothed and segmented by its watershed, specks are left out,
// and the labels become walls for VTK. (For an image of membranes, leave out the inversion.)
//
// usage: WatershedToWalls nuclei.mha walls.vtp [SIGMA LEVEL]
// SIGMA of the smoothing, about half a nucleus' radius (1.5), and LEVEL, the depth of a minimum that is a cell's (5).
#include "TissueTessellationVTKBridge.h"
#include "itkImageFileReader.h"
#include "itkInvertIntensityImageFilter.h"
#include "itkLabelImageToCellWallMeshFilter.h"
#include "itkMaskImageFilter.h"
#include "itkMorphologicalWatershedImageFilter.h"
#include "itkOtsuThresholdImageFilter.h"
#include "itkRelabelComponentImageFilter.h"
#include "itkSmoothingRecursiveGaussianImageFilter.h"
#include "vtkXMLPolyDataWriter.h"

#include <cstdlib>
#include <iostream>

namespace
{
using ImageType = itk::Image<float, 3>;
using LabelImageType = itk::Image<unsigned short, 3>;
using SmoothingType = itk::SmoothingRecursiveGaussianImageFilter<ImageType>;

/** \param sigma in the image's units. */
ImageType::Pointer
Smooth(const ImageType * image, double sigma)
{
  const auto filter = SmoothingType::New();
  filter->SetInput(image);
  filter->SetSigma(sigma);
  filter->Update();
  return filter->GetOutput();
}

/** The watershed of the inverted nuclei, 0 where the image is dark even from afar. */
LabelImageType::Pointer
Segment(const ImageType * nuclei, double sigma, double level)
{
  const auto inverted = itk::InvertIntensityImageFilter<ImageType>::New();
  inverted->SetInput(Smooth(nuclei, sigma));
  inverted->SetMaximum(0.0f); // The greatest float would leave nothing of the image.
  const auto watershed = itk::MorphologicalWatershedImageFilter<ImageType, LabelImageType>::New();
  watershed->SetInput(inverted->GetOutput());
  watershed->SetLevel(level);
  watershed->MarkWatershedLineOff();
  const auto tissue = itk::OtsuThresholdImageFilter<ImageType, LabelImageType>::New();
  tissue->SetInput(Smooth(nuclei, 4.0 * sigma));
  tissue->SetInsideValue(0);
  tissue->SetOutsideValue(1);
  const auto cells = itk::MaskImageFilter<LabelImageType, LabelImageType>::New();
  cells->SetInput(watershed->GetOutput());
  cells->SetMaskImage(tissue->GetOutput());
  const auto large = itk::RelabelComponentImageFilter<LabelImageType, LabelImageType>::New();
  large->SetInput(cells->GetOutput());
  large->SetMinimumObjectSize(100);
  large->Update();
  return large->GetOutput();
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc < 3)
  {
    std::cerr << "usage: " << argv[0] << " nuclei.mha walls.vtp [SIGMA LEVEL]" << std::endl;
    return EXIT_FAILURE;
  }
  try
  {
    const auto nuclei = itk::ReadImage<ImageType>(argv[1]);
    const auto filter = itk::LabelImageToCellWallMeshFilter<LabelImageType>::New();
    filter->SetInput(Segment(nuclei, argc > 3 ? std::atof(argv[3]) : 1.5, argc > 4 ? std::atof(argv[4]) : 5.0));
    filter->Update();
    const itk::CellWallMesh * const mesh = filter->GetOutput();
    std::cout << mesh->GetNumberOfCells() << " cells, " << mesh->GetNumberOfTriangles() << " triangles" << std::endl;
    vtkNew<vtkXMLPolyDataWriter> writer;
    writer->SetInputData(tissue::MakeWallPolyData(mesh->GetWallMesh(), mesh->GetJunctionSet().cells));
    writer->SetFileName(argv[2]);
    return writer->Write() == 1 ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
