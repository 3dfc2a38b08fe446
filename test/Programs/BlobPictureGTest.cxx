/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "NucleiDetection/BlobPicture.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <itkImageFileReader.h>
#include <itkPNGImageIO.h>
#include <itkRGBPixel.h>

#include <stdexcept>

namespace
{
using Color = itk::RGBPixel<unsigned char>;
using Picture = itk::Image<Color, 2>;

Color
Grey(unsigned char value)
{
  Color color;
  color.Fill(value);
  return color;
}

Color
Orange()
{
  Color color;
  color.Set(255, 140, 0);
  return color;
}

/** 20 x 10 x 5 voxels of 1 x 1 x 2 units, dark but for one, in axes that are turned and moved. */
class BlobPicture : public TemporaryFolderTest
{
protected:
  void
  SetUp() override
  {
    TemporaryFolderTest::SetUp();
    m_Image = MakeImage({ { 20, 10, 5 } });
    const double                       spacing[] = { 1.0, 1.0, 2.0 };
    const double                       origin[] = { -7.0, 100.0, 3.0 };
    tissue::ScalarImage::DirectionType direction;
    direction.Fill(0.0);
    direction[0][1] = -1.0;
    direction[1][2] = 1.0;
    direction[2][0] = 1.0;
    m_Image->SetSpacing(spacing);
    m_Image->SetOrigin(origin);
    m_Image->SetDirection(direction);
    m_Image->SetPixel({ { 15, 2, 3 } }, 50.0f);
  }

  static tissue::ScalarImage::Pointer
  MakeImage(const itk::Size<3> & size)
  {
    const auto image = tissue::ScalarImage::New();
    image->SetRegions(size);
    image->Allocate(true);
    return image;
  }

  Picture::Pointer
  Draw(const tissue::ScalarImage * image, const tissue::PointTable & blobs) const
  {
    tissue::WriteBlobPicture(image, blobs, PathOf("blobs.png"));
    const auto reader = itk::ImageFileReader<Picture>::New();
    reader->SetImageIO(itk::PNGImageIO::New());
    reader->SetFileName(PathOf("blobs.png"));
    reader->Update();
    return reader->GetOutput();
  }

  tissue::ScalarImage::Pointer m_Image;
};
} // namespace

TEST_F(BlobPicture, ShowsTheBrightestVoxelsAlongTwoAxes)
{
  const auto picture = this->Draw(m_Image, {});
  // 40 pixels a unit: 10 units, then 5 voxels of 2 units.
  ASSERT_EQ(picture->GetLargestPossibleRegion().GetSize(), (itk::Size<2>{ { 800, 800 } }));
  for (itk::IndexValueType y = 0; y < 800; ++y)
  {
    for (itk::IndexValueType x = 0; x < 800; ++x)
    {
      const bool isInAbove = y >= 80 && y < 120;
      const bool isInBelow = y >= 400 + 240 && y < 400 + 320;
      const bool isBright = x >= 600 && x < 640 && (isInAbove || isInBelow);
      ASSERT_EQ(picture->GetPixel({ { x, y } }), Grey(isBright ? 255 : 0)) << x << ' ' << y;
    }
  }
}

TEST_F(BlobPicture, CirclesThePointsAtTheirRadii)
{
  itk::Point<double, 3> center;
  m_Image->TransformIndexToPhysicalPoint(itk::Index<3>{ { 15, 2, 3 } }, center);
  itk::Point<double, 3> corner;
  m_Image->TransformIndexToPhysicalPoint(itk::Index<3>{ { 0, 0, 0 } }, corner);
  tissue::PointTable blobs;
  blobs.points = { { { center[0], center[1], center[2] } }, { { corner[0], corner[1], corner[2] } } };
  blobs.columns = { { "radius", { 1.5, 3.0 } } };
  const auto picture = this->Draw(m_Image, blobs);
  // The voxel's centre is 15.5, 2.5 and 3.5 voxels from the corner of the image; the radius is 60 pixels.
  for (const itk::Index<2> & onCircle : { itk::Index<2>{ { 680, 100 } },
                                          itk::Index<2>{ { 620, 160 } },
                                          itk::Index<2>{ { 620, 40 } },
                                          itk::Index<2>{ { 680, 400 + 280 } },
                                          itk::Index<2>{ { 620, 400 + 340 } },
                                          itk::Index<2>{ { 620, 400 + 220 } } })
  {
    EXPECT_EQ(picture->GetPixel(onCircle), Orange()) << onCircle;
  }
  EXPECT_EQ(picture->GetPixel({ { 620, 100 } }), Grey(255)) << "within";
  EXPECT_EQ(picture->GetPixel({ { 700, 100 } }), Grey(0)) << "without";
  // One that leaves the picture does not come in on the other side, or in the other panel.
  EXPECT_EQ(picture->GetPixel({ { 140, 20 } }), Orange());
  int beside = 0;
  for (itk::IndexValueType y = 0; y < 800; ++y)
  {
    beside += picture->GetPixel({ { 799, y } }) == Orange() || picture->GetPixel({ { y, 399 } }) == Orange() ? 1 : 0;
  }
  EXPECT_EQ(beside, 0);
}

TEST_F(BlobPicture, LongImagesAndFlatOnesHaveNoMorePixels)
{
  const auto deep = this->Draw(MakeImage({ { 2, 3, 1000 } }), {})->GetLargestPossibleRegion().GetSize();
  EXPECT_EQ(deep, (itk::Size<2>{ { 2, 2 + 800 } }));
  const auto thin = this->Draw(MakeImage({ { 1000, 1, 1 } }), {})->GetLargestPossibleRegion().GetSize();
  EXPECT_EQ(thin, (itk::Size<2>{ { 800, 2 } }));
}

TEST_F(BlobPicture, ThrowsWhereItCannotBeWritten)
{
  EXPECT_THROW(tissue::WriteBlobPicture(m_Image, {}, PathOf("none/blobs.png")), std::runtime_error);
}
