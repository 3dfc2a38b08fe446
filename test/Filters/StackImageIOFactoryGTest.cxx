/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "itkStackImageIOFactory.h"

#include "StackTestFiles.h"

#include <itkTIFFImageIOFactory.h>

#include <gtest/gtest.h>

class StackImageIOFactory : public TemporaryFolderTest
{};

TEST_F(StackImageIOFactory, ComesBeforeITKsReaders)
{
  const std::string path = this->PathOf("a.tif");
  WriteTIFF<std::uint32_t>(path, {}, 2);
  itk::TIFFImageIOFactory::RegisterOneFactory();
  itk::StackImageIOFactory::RegisterOneFactory();
  itk::StackImageIOFactory::RegisterOneFactory();
  const auto image = itk::ReadImage<itk::Image<std::uint32_t, 3>>(path);
  EXPECT_EQ(SliceOf(image.GetPointer(), 1), MakePage<std::uint32_t>(1));
  const auto io = itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::ImageIOFactory::IOFileModeEnum::ReadMode);
  EXPECT_STREQ(io->GetNameOfClass(), "StackTIFFImageIO");
  const auto writer = itk::ImageIOFactory::CreateImageIO(path.c_str(), itk::ImageIOFactory::IOFileModeEnum::WriteMode);
  EXPECT_STREQ(writer->GetNameOfClass(), "TIFFImageIO") << "they write nothing";
}
