/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "NucleiDetection/BlobPicture.h"

#include "Shared/Files/VTKFiles.h"

#include <itkContinuousIndex.h>
#include <itkMaximumProjectionImageFilter.h>
#include <itkRGBPixel.h>
#include <vtkImageData.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tissue
{
namespace
{
using Color = itk::RGBPixel<unsigned char>;
using Picture = itk::Image<Color, 2>;

constexpr double PanelSize = 800.0;
constexpr double DarkestShare = 0.01;
constexpr double BrightestShare = 0.998;

/** A projection of the image: which of its axes go right and down, and which one is looked along. */
struct Panel
{
  unsigned int right;
  unsigned int down;
  unsigned int along;
};
constexpr Panel Panels[] = { { 0, 1, 2 }, { 0, 2, 1 } };

ScalarImage::Pointer
Project(const ScalarImage * image, unsigned int along)
{
  const auto projection = itk::MaximumProjectionImageFilter<ScalarImage, ScalarImage>::New();
  projection->SetInput(image);
  projection->SetProjectionDimension(along);
  projection->Update();
  return projection->GetOutput();
}

/** Draws the panel with its upper left corner at this row. */
class PanelDrawing
{
public:
  PanelDrawing(const ScalarImage * image, const Panel & panel, double pixelsPerUnit, Picture * picture, int firstRow)
    : m_Image(image)
    , m_Panel(panel)
    , m_PixelsPerUnit(pixelsPerUnit)
    , m_Picture(picture)
    , m_FirstRow(firstRow)
  {}

  static int
  Length(const ScalarImage * image, unsigned int axis, double pixelsPerUnit)
  {
    return std::max(
      1,
      static_cast<int>(std::lround(pixelsPerUnit * image->GetSpacing()[axis] *
                                   static_cast<double>(image->GetLargestPossibleRegion().GetSize(axis)))));
  }

  void
  DrawVoxels() const
  {
    const auto         projected = Project(m_Image, m_Panel.along);
    const auto         region = projected->GetBufferedRegion();
    std::vector<float> values(projected->GetBufferPointer(),
                              projected->GetBufferPointer() + region.GetNumberOfPixels());
    std::sort(values.begin(), values.end());
    const auto valueAt = [&values](double share) {
      return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
    };
    const double darkest = valueAt(DarkestShare);
    const double brightest = std::max<double>(valueAt(BrightestShare), darkest + 1e-30);
    for (int y = 0; y < Length(m_Image, m_Panel.down, m_PixelsPerUnit); ++y)
    {
      for (int x = 0; x < Length(m_Image, m_Panel.right, m_PixelsPerUnit); ++x)
      {
        auto index = region.GetIndex();
        index[m_Panel.right] += this->VoxelAt(x, m_Panel.right);
        index[m_Panel.down] += this->VoxelAt(y, m_Panel.down);
        const double share = std::clamp((projected->GetPixel(index) - darkest) / (brightest - darkest), 0.0, 1.0);
        Color        color;
        color.Fill(static_cast<unsigned char>(255.0 * share));
        m_Picture->SetPixel({ { x, m_FirstRow + y } }, color);
      }
    }
  }

  void
  DrawCircle(const Point & center, double radius) const
  {
    itk::ContinuousIndex<double, 3> place;
    m_Image->TransformPhysicalPointToContinuousIndex(itk::Point<double, 3>(center.data()), place);
    const auto toPixel = [&](unsigned int axis) {
      return (place[axis] + 0.5 - static_cast<double>(m_Image->GetLargestPossibleRegion().GetIndex(axis))) *
             m_Image->GetSpacing()[axis] * m_PixelsPerUnit;
    };
    const double pixels = radius * m_PixelsPerUnit;
    const int    steps = std::max(16, static_cast<int>(std::ceil(8.0 * pixels)));
    for (int i = 0; i < steps; ++i)
    {
      const double angle = 2.0 * itk::Math::pi * i / steps;
      const auto   x = static_cast<int>(std::floor(toPixel(m_Panel.right) + pixels * std::cos(angle)));
      const auto   y = static_cast<int>(std::floor(toPixel(m_Panel.down) + pixels * std::sin(angle)));
      if (x >= 0 && x < Length(m_Image, m_Panel.right, m_PixelsPerUnit) && y >= 0 &&
          y < Length(m_Image, m_Panel.down, m_PixelsPerUnit))
      {
        Color orange;
        orange.Set(255, 140, 0);
        m_Picture->SetPixel({ { x, m_FirstRow + y } }, orange);
      }
    }
  }

private:
  itk::IndexValueType
  VoxelAt(int pixel, unsigned int axis) const
  {
    const auto last = static_cast<itk::IndexValueType>(m_Image->GetLargestPossibleRegion().GetSize(axis)) - 1;
    return std::min(last,
                    static_cast<itk::IndexValueType>((pixel + 0.5) / (m_PixelsPerUnit * m_Image->GetSpacing()[axis])));
  }

  const ScalarImage * m_Image;
  const Panel &       m_Panel;
  double              m_PixelsPerUnit;
  Picture *           m_Picture;
  int                 m_FirstRow;
};

void
Write(const Picture * picture, const std::string & path)
{
  const auto                 size = picture->GetLargestPossibleRegion().GetSize();
  const vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(size[0]), static_cast<int>(size[1]), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  for (std::size_t y = 0; y < size[1]; ++y)
  {
    // VTK's first row is the lowest.
    auto * const row = static_cast<Color *>(image->GetScalarPointer(0, static_cast<int>(size[1] - 1 - y), 0));
    std::copy_n(picture->GetBufferPointer() + y * size[0], size[0], row);
  }
  WritePNG(image, path);
}
} // namespace

void
WriteBlobPicture(const ScalarImage * image, const PointTable & blobs, const std::string & path)
{
  const auto size = image->GetLargestPossibleRegion().GetSize();
  double     longest = 0.0;
  for (unsigned int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, image->GetSpacing()[axis] * static_cast<double>(size[axis]));
  }
  const double pixelsPerUnit = PanelSize / longest;
  int          rows = 0;
  for (const Panel & panel : Panels)
  {
    rows += PanelDrawing::Length(image, panel.down, pixelsPerUnit);
  }
  const auto picture = Picture::New();
  picture->SetRegions(
    Picture::SizeType{ { static_cast<itk::SizeValueType>(PanelDrawing::Length(image, 0, pixelsPerUnit)),
                         static_cast<itk::SizeValueType>(rows) } });
  picture->Allocate(true);
  const std::vector<double> * const radii = blobs.FindColumn("radius");
  int                               firstRow = 0;
  for (const Panel & panel : Panels)
  {
    const PanelDrawing drawing(image, panel, pixelsPerUnit, picture, firstRow);
    drawing.DrawVoxels();
    for (std::size_t i = 0; i < blobs.points.size(); ++i)
    {
      drawing.DrawCircle(blobs.points[i], radii != nullptr ? (*radii)[i] : 0.0);
    }
    firstRow += PanelDrawing::Length(image, panel.down, pixelsPerUnit);
  }
  Write(picture, path);
}
} // namespace tissue
