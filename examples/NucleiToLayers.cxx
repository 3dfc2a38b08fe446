/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// From nuclei to a table of layers: ITK's median takes off the noise, then our filters find the nuclei, estimate
// the tissue around them, with the votes on which cells meet, and make and measure its walls.
//
// usage: NucleiToLayers nuclei.mha
#include "itkCellWallMeshStatisticsCalculator.h"
#include "itkDifferenceOfGaussiansBlobDetectionFilter.h"
#include "itkImageFileReader.h"
#include "itkLabelImageToCellWallMeshFilter.h"
#include "itkMedianImageFilter.h"
#include "itkPointSetToTissueLabelImageFilter.h"

#include <cstdlib>
#include <iostream>
#include <map>

namespace
{
struct Layer
{
  unsigned int cells = 0;
  double       volume = 0.0;
};

/** The layers of the tissue, 1 the epidermis. */
std::map<int, Layer>
MeasureLayers(const itk::CellWallMesh * mesh)
{
  const auto calculator = itk::CellWallMeshStatisticsCalculator::New();
  calculator->SetMesh(mesh);
  calculator->Compute();
  const auto           numbers = calculator->GetCellColumn("Layer");
  const auto           volumes = calculator->GetCellColumn("Volume");
  std::map<int, Layer> layers;
  for (itk::IdentifierType cell = 0; cell < numbers->Size(); ++cell)
  {
    Layer & layer = layers[static_cast<int>(numbers->GetElement(cell))];
    ++layer.cells;
    layer.volume += volumes->GetElement(cell);
  }
  return layers;
}
} // namespace

int
main(int argc, char * argv[])
{
  if (argc < 2)
  {
    std::cerr << "usage: " << argv[0] << " nuclei.mha" << std::endl;
    return EXIT_FAILURE;
  }
  using ImageType = itk::Image<unsigned short, 3>;
  using DetectionType = itk::DifferenceOfGaussiansBlobDetectionFilter<ImageType>;
  using TissueType = itk::PointSetToTissueLabelImageFilter<DetectionType::OutputType, ImageType>;
  try
  {
    const auto median = itk::MedianImageFilter<ImageType, ImageType>::New();
    median->SetInput(itk::ReadImage<ImageType>(argv[1]));
    const auto detection = DetectionType::New();
    detection->SetInput(median->GetOutput());
    const auto tissue = TissueType::New();
    tissue->SetInput(detection->GetOutput());
    tissue->SetReferenceImage(median->GetOutput());
    const auto walls = itk::LabelImageToCellWallMeshFilter<ImageType>::New();
    walls->SetInput(tissue->GetOutput());
    walls->SetVotes(tissue->GetVotes());
    walls->Update();
    std::cout << "layer,cells,mean volume\n";
    for (const auto & [number, layer] : MeasureLayers(walls->GetOutput()))
    {
      std::cout << number << ',' << layer.cells << ',' << layer.volume / layer.cells << '\n';
    }
    return EXIT_SUCCESS;
  }
  catch (const std::exception & error)
  {
    std::cerr << error.what() << std::endl;
    return EXIT_FAILURE;
  }
}
