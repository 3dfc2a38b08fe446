/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "StackTestFiles.h"
#include "itkStackHDF5ImageIO.h"
#include "itk_hdf5.h"

#include <gtest/gtest.h>

#include <numeric>

namespace
{
using Shape = std::vector<hsize_t>;

class StackHDF5ImageIO : public TemporaryFolderTest
{
protected:
  void
  SetUp() override
  {
    TemporaryFolderTest::SetUp();
    m_Path = this->PathOf("a.h5");
    m_File = H5Fcreate(m_Path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  }

  /** A data set whose numbers are 0, 1, 2, ... in the order of the file; compressed. */
  void
  Add(const std::string & name, const Shape & shape, hid_t type, const std::string & axisTags = "",
      const std::vector<double> & size = {})
  {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
    H5Pset_chunk(creation, static_cast<int>(shape.size()), shape.data());
    H5Pset_deflate(creation, 4);
    const hid_t links = H5Pcreate(H5P_LINK_CREATE);
    H5Pset_create_intermediate_group(links, 1);
    const hid_t      set = H5Dcreate2(m_File, name.c_str(), type, space, links, creation, H5P_DEFAULT);
    std::vector<int> numbers(
      std::accumulate(shape.begin(), shape.end(), std::size_t{ 1 }, std::multiplies<std::size_t>()));
    std::iota(numbers.begin(), numbers.end(), 0);
    H5Dwrite(set, H5T_NATIVE_INT, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data());
    if (!axisTags.empty())
    {
      const hid_t text = H5Tcopy(H5T_C_S1);
      H5Tset_size(text, H5T_VARIABLE);
      const hid_t  scalar = H5Screate(H5S_SCALAR);
      const hid_t  attribute = H5Acreate2(set, "axistags", text, scalar, H5P_DEFAULT, H5P_DEFAULT);
      const char * value = axisTags.c_str();
      H5Awrite(attribute, text, &value);
      H5Aclose(attribute);
    }
    if (!size.empty())
    {
      const hsize_t three = 3;
      const hid_t   attribute = H5Acreate2(
        set, "element_size_um", H5T_IEEE_F64LE, H5Screate_simple(1, &three, nullptr), H5P_DEFAULT, H5P_DEFAULT);
      H5Awrite(attribute, H5T_NATIVE_DOUBLE, size.data());
      H5Aclose(attribute);
    }
    H5Dclose(set);
  }

  /** The tags of axes as ilastik writes them. */
  static std::string
  TagsOf(const std::string & axes, const std::string & resolution = "0")
  {
    std::string text;
    for (const char axis : axes)
    {
      text += std::string(text.empty() ? "" : ", ") + "{\"key\": \"" + axis +
              "\", \"typeFlags\": 2, \"resolution\": " + resolution + ", \"description\": \"\"}";
    }
    return "{\n  \"axes\": [" + text + "]\n}";
  }

  itk::Image<int, 3>::Pointer
  Read(const std::string & name = "", unsigned int channel = 0, unsigned int frame = 0)
  {
    this->Close();
    m_IO = itk::StackHDF5ImageIO::New();
    m_IO->SetChannel(channel);
    m_IO->SetFrame(frame);
    m_IO->SetPrefersIntegers(m_PrefersIntegers);
    const std::string path = m_Path + name;
    EXPECT_TRUE(m_IO->CanReadFile(path.c_str()));
    return ReadStack<int>(m_IO, path);
  }

  std::string
  Refusal(const std::string & name = "")
  {
    return WordsOf([&] { this->Read(name); });
  }

  void
  Close()
  {
    if (m_File >= 0)
    {
      H5Fclose(m_File);
      m_File = -1;
    }
  }

  std::string                    m_Path;
  hid_t                          m_File = -1;
  bool                           m_PrefersIntegers = true;
  itk::StackHDF5ImageIO::Pointer m_IO;
};
} // namespace

TEST_F(StackHDF5ImageIO, ReadsTheOnlyVolumeWithItsSize)
{
  this->Add("label", { 4, 3, 5 }, H5T_STD_U16BE, "", { 0.9, 0.4, 0.3 });
  this->Add("names", { 7 }, H5T_STD_I32LE);
  const auto image = this->Read();
  EXPECT_EQ(image->GetLargestPossibleRegion().GetSize(), (itk::Size<3>{ { 5, 3, 4 } }));
  ExpectSpacing(image.GetPointer(), { { 0.3, 0.4, 0.9 } });
  EXPECT_EQ(image->GetPixel({ { 2, 1, 3 } }), (3 * 3 + 1) * 5 + 2);
  EXPECT_EQ(m_IO->GetComponentType(), itk::IOComponentEnum::USHORT);
  EXPECT_TRUE(m_IO->GetIsInMicrometers());
}

TEST_F(StackHDF5ImageIO, RefusesSizesThatTheFileCannotHold)
{
  const Shape shape{ 2000, 2000, 2000 };
  const hid_t space = H5Screate_simple(3, shape.data(), nullptr);
  H5Dclose(H5Dcreate2(m_File, "label", H5T_STD_U8LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  H5Sclose(space);
  EXPECT_NE(this->Refusal().find("holds 0 bytes in the file"), std::string::npos);
}

TEST_F(StackHDF5ImageIO, TakesTheNamedSetOrTheOnlyOneOfIntegers)
{
  this->Add("raw", { 4, 3, 5 }, H5T_IEEE_F32LE);
  this->Add("cells/label", { 2, 3, 6 }, H5T_STD_U32LE);
  EXPECT_EQ(this->Read()->GetLargestPossibleRegion().GetSize(0), 6u);
  EXPECT_EQ(this->Read(":/raw")->GetLargestPossibleRegion().GetSize(0), 5u);
  EXPECT_EQ(this->Read(":cells/label")->GetLargestPossibleRegion().GetSize(0), 6u);
  m_PrefersIntegers = false;
  EXPECT_NE(this->Refusal().find("/cells/label (2 x 3 x 6, uint32), /raw (4 x 3 x 5, float32)"), std::string::npos)
    << this->Refusal();
  EXPECT_NE(this->Refusal(":/none").find("no data set '/none'"), std::string::npos) << this->Refusal(":/none");
}

TEST_F(StackHDF5ImageIO, RefusesToGuessAmongSeveral)
{
  this->Add("a", { 4, 3, 5 }, H5T_STD_U8LE);
  this->Add("b", { 4, 3, 5 }, H5T_STD_I64LE);
  EXPECT_NE(this->Refusal().find("/a (4 x 3 x 5, uint8), /b (4 x 3 x 5, int64); FILE:/NAME names one"),
            std::string::npos)
    << this->Refusal();
}

TEST_F(StackHDF5ImageIO, FollowsTheTagsOfAxes)
{
  this->Add("exported_data", { 1, 5, 3, 4, 2 }, H5T_STD_U32LE, TagsOf("txyzc", "0.5"));
  EXPECT_NE(this->Refusal().find("2 channels"), std::string::npos);
  const auto image = this->Read("", 2);
  ASSERT_EQ(image->GetLargestPossibleRegion().GetSize(), (itk::Size<3>{ { 5, 3, 4 } }));
  for (int x = 0; x < 5; ++x)
  {
    EXPECT_EQ(image->GetPixel({ { x, 1, 3 } }), ((x * 3 + 1) * 4 + 3) * 2 + 1);
  }
  ExpectSpacing(image.GetPointer(), { { 0.5, 0.5, 0.5 } });
  EXPECT_FALSE(m_IO->GetIsInMicrometers());
}

TEST_F(StackHDF5ImageIO, GuessesAxesWithoutTags)
{
  this->Add("a", { 1, 4, 3, 5, 1 }, H5T_STD_U8LE);
  EXPECT_EQ(this->Read()->GetPixel({ { 2, 1, 3 } }), (3 * 3 + 1) * 5 + 2);
  m_File = H5Fcreate(m_Path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  this->Add("a", { 2, 4, 3, 5 }, H5T_STD_U8LE);
  EXPECT_EQ(this->Read("", 2)->GetPixel({ { 2, 1, 3 } }), ((4 + 3) * 3 + 1) * 5 + 2);
  m_File = H5Fcreate(m_Path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
  this->Add("a", { 4, 3, 5, 2 }, H5T_STD_U8LE);
  EXPECT_EQ(this->Read("", 2)->GetPixel({ { 2, 1, 3 } }), ((3 * 3 + 1) * 5 + 2) * 2 + 1);
  EXPECT_FALSE(m_IO->HasSpacing(0));
}

TEST_F(StackHDF5ImageIO, LeavesITKsOwnFilesToITK)
{
  this->Add("ITKImage/0/VoxelData", { 4, 3, 5 }, H5T_STD_U8LE);
  this->Close();
  EXPECT_FALSE(itk::StackHDF5ImageIO::New()->CanReadFile(m_Path.c_str()));
  std::ofstream(this->PathOf("text.h5")) << "Dear reader,";
  EXPECT_FALSE(itk::StackHDF5ImageIO::New()->CanReadFile(this->PathOf("text.h5").c_str()));
}

TEST_F(StackHDF5ImageIO, RefusesFilesThatAreCutOff)
{
  this->Add("a", { 40, 30, 50 }, H5T_STD_U32LE);
  this->Close();
  std::filesystem::resize_file(m_Path, std::filesystem::file_size(m_Path) / 2);
  EXPECT_NE(this->Refusal().find("cut off or broken"), std::string::npos) << this->Refusal();
}
