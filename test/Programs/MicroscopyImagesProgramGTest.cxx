/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// The programs on the files that programs of microscopy write.
#include "StackTestFiles.h"
#include "TissueTessellationProgramTest.h"
#include "itk_hdf5.h"
#include "itk_zlib.h"

#include <itkCastImageFilter.h>
#include <nifti1.h>

namespace
{
/** The test tissue, in any type of numbers. */
template <typename TPixel>
typename itk::Image<TPixel, 3>::Pointer
MakeTissue()
{
  const auto cast = itk::CastImageFilter<itk::Image<unsigned short, 3>, itk::Image<TPixel, 3>>::New();
  cast->SetInput(MakeSyntheticTestTissue<unsigned short>());
  cast->Update();
  return cast->GetOutput();
}

class MicroscopyImages : public TissueTessellationAppTest
{
protected:
  void
  SetUp() override
  {
    TissueTessellationAppTest::SetUp();
    this->WriteTissue<unsigned short>("reference.mha");
    ASSERT_EQ(this->Run("reference.mha reference.vtp --refinement 0"), 0) << m_Errors;
  }

  /** The slices of the test tissue, each as often as there are channels, and all of them for each frame; those of the
   * second channel and frame have but zeros. */
  template <typename TPixel>
  void
  WriteTissueTIFF(const std::string & name, TIFFRecipe recipe, std::size_t channels = 1, std::size_t frames = 1)
  {
    const auto image = MakeTissue<TPixel>();
    const auto size = image->GetLargestPossibleRegion().GetSize();
    recipe.width = static_cast<std::uint32_t>(size[0]);
    recipe.height = static_cast<std::uint32_t>(size[1]);
    std::vector<std::vector<TPixel>> pages;
    for (std::size_t t = 0; t < frames; ++t)
    {
      for (std::size_t z = 0; z < size[2]; ++z)
      {
        for (std::size_t c = 0; c < channels; ++c)
        {
          const bool isTissue = c == channels - 1 && t == frames - 1;
          pages.push_back(isTissue ? SliceOf(image.GetPointer(), z) : std::vector<TPixel>(size[0] * size[1]));
        }
      }
    }
    WriteTIFFPages(this->PathOf(name), recipe, pages);
  }

  /** The walls are those of the MetaImage file. */
  void
  ExpectReference(const std::string & arguments)
  {
    ASSERT_EQ(this->Run(arguments + " walls.vtp --refinement 0"), 0) << arguments << ": " << m_Errors;
    EXPECT_TRUE(ReadBytes(this->PathOf("walls.vtp")) == ReadBytes(this->PathOf("reference.vtp"))) << arguments;
  }

  /** Resolution and spacing of the test tissue as Fiji has it. */
  static TIFFRecipe
  FijiRecipe(const std::string & more = "images=18\nslices=18\n")
  {
    TIFFRecipe recipe;
    recipe.description = "ImageJ=1.53t\n" + more + "unit=um\nspacing=1.0\nloop=false\n";
    recipe.xResolution = 2.0f;
    recipe.yResolution = 2.0f;
    return recipe;
  }

  void
  WriteHDF5(const std::string & name)
  {
    const auto    image = MakeSyntheticTestTissue<unsigned short>();
    const hsize_t shape[] = { 18, 40, 40 };
    const hid_t   file = H5Fcreate(this->PathOf(name).c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT);
    const hid_t   space = H5Screate_simple(3, shape, nullptr);
    for (const char * set : { "/label", "/other" })
    {
      const hid_t dataset = H5Dcreate2(file, set, H5T_STD_U16LE, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
      H5Dwrite(dataset, H5T_NATIVE_USHORT, H5S_ALL, H5S_ALL, H5P_DEFAULT, image->GetBufferPointer());
      const hsize_t three = 3;
      const double  size[] = { 1.0, 0.5, 0.5 };
      const hid_t   numbers = H5Screate_simple(1, &three, nullptr);
      const hid_t attribute = H5Acreate2(dataset, "element_size_um", H5T_IEEE_F64LE, numbers, H5P_DEFAULT, H5P_DEFAULT);
      H5Awrite(attribute, H5T_NATIVE_DOUBLE, size);
      H5Aclose(attribute);
      H5Dclose(dataset);
    }
    H5Fclose(file);
  }

  void
  WriteInrGz(const std::string & name)
  {
    const auto  image = MakeSyntheticTestTissue<unsigned short>();
    std::string header = "#INRIMAGE-4#{\nXDIM=40\nYDIM=40\nZDIM=18\nVDIM=1\nTYPE=unsigned fixed\nPIXSIZE=16 bits\n"
                         "SCALE=2**0\nCPU=decm\nVX=0.5\nVY=0.5\nVZ=1\n";
    header.resize(252, '\n');
    header += "##}\n";
    const gzFile file = gzopen(this->PathOf(name).c_str(), "wb");
    gzwrite(file, header.data(), static_cast<unsigned int>(header.size()));
    gzwrite(file, image->GetBufferPointer(), 18 * 40 * 40 * 2);
    gzclose(file);
  }

  /** Changes the header of an uncompressed NIfTI file. */
  template <typename TChange>
  void
  ChangeNifti(const std::string & name, const TChange & change)
  {
    std::fstream   file(this->PathOf(name), std::ios::in | std::ios::out | std::ios::binary);
    nifti_1_header header;
    file.read(reinterpret_cast<char *>(&header), sizeof(header));
    change(header);
    file.seekp(0);
    file.write(reinterpret_cast<const char *>(&header), sizeof(header));
  }
};
} // namespace

TEST_F(MicroscopyImages, GiveTheWallsOfTheirLabels)
{
  this->WriteTissueTIFF<std::uint32_t>("uint32.tif", FijiRecipe());
  this->ExpectReference("uint32.tif");
  EXPECT_EQ(m_Errors, "");
  this->WriteTissueTIFF<float>("float.tif", FijiRecipe());
  this->ExpectReference("float.tif");
  TIFFRecipe tiled = FijiRecipe();
  tiled.tileSize = 16;
  tiled.compression = COMPRESSION_ADOBE_DEFLATE;
  this->WriteTissueTIFF<std::int32_t>("tiled.tif", tiled);
  this->ExpectReference("tiled.tif");
  TIFFRecipe palette = FijiRecipe();
  palette.photometric = PHOTOMETRIC_PALETTE;
  this->WriteTissueTIFF<std::uint8_t>("palette.tif", palette);
  this->ExpectReference("palette.tif");
  this->WriteInrGz("tissue.inr.gz");
  this->ExpectReference("tissue.inr.gz");
  this->WriteHDF5("tissue.h5");
  this->ExpectReference("tissue.h5:/label");
  this->ExpectRefusal("tissue.h5 walls.vtp", { "/label (18 x 40 x 40, uint16), /other", "FILE:/NAME" });
  m_Program = NUCLEI_TESSELLATION_PROGRAM;
  this->Run("tissue.inr.gz walls.vtp --refinement 0");
  EXPECT_EQ(m_Errors.find("neither an image"), std::string::npos) << m_Errors;
  m_Program = TISSUE_TESSELLATION_PROGRAM;
  this->WriteImage(MakeTissue<float>().GetPointer(), "float.mha");
  this->ExpectReference("float.mha");
}

TEST_F(MicroscopyImages, OfSeveralChannelsOrFramesAreRefusedUntilOneIsChosen)
{
  this->WriteTissueTIFF<std::uint16_t>(
    "a.tif", FijiRecipe("images=72\nchannels=2\nslices=18\nframes=2\nhyperstack=true\n"), 2, 2);
  this->ExpectRefusal("a.tif walls.vtp", { "a.tif: ", "2 channels", "--channel", "2 frames", "--frame" });
  this->ExpectRefusal("a.tif walls.vtp --channel 2", { "2 frames", "--frame" });
  this->ExpectReference("a.tif --channel 2 --frame 2");
  this->ExpectRefusal("a.tif walls.vtp --channel 3 --frame 1", { "2 channels, there is no channel 3" });
  this->ExpectRefusal("reference.mha walls.vtp --channel 2", { "1 channel, there is no channel 2" });
  this->ExpectRefusal("reference.mha walls.vtp --channel 0", { "--channel" });
  this->ExpectReference("a.tif --channel 2 --frame 2 --evaluateAgainst reference.mha");
  for (const char * option : { "--evaluateAgainst a.tif", "--membrane a.tif" })
  {
    this->ExpectRefusal(std::string(option == std::string("--membrane a.tif") ? "" : "reference.mha ") + "walls.vtp " +
                          option,
                        { "a.tif: ", "2 channels" });
  }
  m_Program = NUCLEI_DETECTION_PROGRAM;
  this->ExpectRefusal("a.tif points.csv", { "a.tif: ", "2 channels", "--channel" });
  m_Program = NUCLEI_TESSELLATION_PROGRAM;
  std::ofstream(this->PathOf("points.csv")) << "x,y,z\n5,5,5\n15,5,6\n5,15,7\n12,12,12\n9,10,9\n";
  for (const char * arguments : { "a.tif", "--centersOf a.tif" })
  {
    this->ExpectRefusal(std::string(arguments) + " walls.vtp", { "a.tif: ", "2 channels", "--channel", "--frame" });
  }
  this->ExpectRefusal("a.tif walls.vtp --channel 1 --frame last", { "--frame last", "a number from 1 on" });
  this->ExpectRefusal("points.csv walls.vtp --membrane a.tif", { "a.tif: ", "--channel", "--membraneFrame" });
  this->ExpectRefusal("points.csv walls.vtp --membrane a.tif --channel 2", { "2 frames", "--membraneFrame" });
  EXPECT_EQ(this->Run("points.csv walls.vtp --refinement 0 --box a.tif"), 0) << "all fill one box: " << m_Errors;
  m_Program = TISSUE_MESH_EVALUATION_PROGRAM;
  this->ExpectRefusal("reference.vtp a.tif", { "a.tif: ", "2 channels", "--channel" });
  EXPECT_EQ(this->Run("reference.vtp a.tif --channel 2 --frame 2"), 0) << m_Errors;
}

TEST_F(MicroscopyImages, OfVectorsAndFourDimensionsAreStacksOfWhichOneIsChosen)
{
  const auto tissue = MakeTissue<unsigned short>();
  const auto size = tissue->GetLargestPossibleRegion().GetSize();
  // The labels are the second component, and the third frame; the others are zeros.
  using VectorImage = itk::Image<itk::Vector<unsigned short, 2>, 3>;
  const auto vectors = VectorImage::New();
  vectors->CopyInformation(tissue);
  vectors->SetRegions(size);
  vectors->Allocate(true);
  using SeriesImage = itk::Image<unsigned short, 4>;
  const auto series = SeriesImage::New();
  series->SetRegions(itk::Size<4>{ { size[0], size[1], size[2], 3 } });
  const double spacing[] = { tissue->GetSpacing()[0], tissue->GetSpacing()[1], tissue->GetSpacing()[2], 7.0 };
  series->SetSpacing(spacing);
  series->Allocate(true);
  const auto number = tissue->GetLargestPossibleRegion().GetNumberOfPixels();
  for (std::size_t i = 0; i < number; ++i)
  {
    vectors->GetBufferPointer()[i][1] = tissue->GetBufferPointer()[i];
    series->GetBufferPointer()[2 * number + i] = tissue->GetBufferPointer()[i];
  }
  for (const char * name : { "vectors.mha", "vectors.nrrd", "vectors.nii.gz" })
  {
    this->WriteImage(vectors.GetPointer(), name);
    this->ExpectRefusal(std::string(name) + " walls.vtp", { name, "the file has 2 channels", "--channel 1 to 2" });
    this->ExpectRefusal(std::string(name) + " walls.vtp --channel 3", { "2 channels, there is no channel 3" });
    this->ExpectReference(std::string(name) + " --channel 2");
  }
  for (const char * name : { "series.mha", "series.nrrd", "series.nii" })
  {
    this->WriteImage(series.GetPointer(), name);
    this->ExpectRefusal(std::string(name) + " walls.vtp", { name, "the file has 3 frames", "--frame 1 to 3" });
    this->ExpectReference(std::string(name) + " --frame 3");
  }
  this->ChangeNifti("series.nii", [](nifti_1_header & header) { header.xyzt_units = NIFTI_UNITS_MICRON; });
  ASSERT_EQ(this->Run("series.nii walls.vtp --refinement 0 --frame 3"), 0) << m_Errors;
  EXPECT_NE(m_Errors.find("micrometres"), std::string::npos) << m_Errors;
  std::filesystem::resize_file(this->PathOf("series.nii"), 20000);
  this->ExpectRefusal("series.nii walls.vtp --frame 1", { "series.nii: the file is cut off" });
  m_Program = NUCLEI_DETECTION_PROGRAM;
  this->ExpectRefusal("series.mha points.csv", { "series.mha: ", "3 frames", "--frame 1 to 3" });
}

TEST_F(MicroscopyImages, OfUnknownSizeAreWarnedOfByAllPrograms)
{
  this->WriteTissueTIFF<std::uint16_t>("a.tif", {});
  const std::string words = "the voxels are exactly 1 x 1 x 1";
  std::ofstream(this->PathOf("points.csv")) << "x,y,z\n5,5,5\n15,5,6\n5,15,7\n12,12,12\n9,10,9\n";
  const std::pair<const char *, const char *> runs[] = {
    { TISSUE_TESSELLATION_PROGRAM, "a.tif w.vtp --refinement 0" },
    { TISSUE_TESSELLATION_PROGRAM, "reference.mha w.vtp --refinement 0 --evaluateAgainst a.tif" },
    { TISSUE_MESH_EVALUATION_PROGRAM, "reference.vtp a.tif" },
    { NUCLEI_DETECTION_PROGRAM, "a.tif p.csv" },
    { NUCLEI_TESSELLATION_PROGRAM, "points.csv w.vtp --refinement 0 --box a.tif" },
  };
  for (const auto & [program, arguments] : runs)
  {
    m_Program = program;
    EXPECT_EQ(this->Run(arguments), 0) << arguments << ": " << m_Errors;
    EXPECT_NE(m_Errors.find(words), std::string::npos) << arguments << ": " << m_Errors;
    EXPECT_EQ(this->Run(std::string(arguments) + " --spacing 0.5 0.5 1"), 0) << arguments << ": " << m_Errors;
    EXPECT_EQ(m_Errors.find(words), std::string::npos) << arguments << ": " << m_Errors;
  }
  m_Program = NUCLEI_TESSELLATION_PROGRAM;
  this->ExpectRefusal("points.csv w.vtp --spacing 1 1 1", { "--spacing", "--box" });
  std::ofstream(this->PathOf("mm.csv"))
    << "x,y,z\n0.005,0.005,0.005\n0.015,0.005,0.006\n0.005,0.015,0.007\n0.012,0.012,0.01\n";
  this->ExpectRefusal("mm.csv w.vtp --box a.tif", { "not in one unit", "points were in millimetres" });
}

TEST_F(MicroscopyImages, TellTheUnitOfTheirLengths)
{
  this->WriteTissueTIFF<std::uint16_t>("a.tif", FijiRecipe());
  EXPECT_EQ(this->RunAndReport("a.tif walls.vtp --refinement 0")["input"]["unit"], "micrometres");
  EXPECT_NE(m_Output.find("voxels of 0.5 x 0.5 x 1 micrometres"), std::string::npos) << m_Output;
  EXPECT_TRUE(this->RunAndReport("reference.mha walls.vtp --refinement 0")["input"]["unit"].is_null());
  EXPECT_TRUE(this->RunAndReport("a.tif walls.vtp --refinement 0 --spacing 1 1 1")["input"]["unit"].is_null());
  this->WriteTissue<short>("a.nii");
  EXPECT_EQ(this->RunAndReport("a.nii walls.vtp --refinement 0")["input"]["unit"], "millimetres");
  this->ChangeNifti("a.nii", [](nifti_1_header & header) { header.xyzt_units = NIFTI_UNITS_MICRON; });
  const auto input = this->RunAndReport("a.nii walls.vtp --refinement 0")["input"];
  EXPECT_EQ(input["unit"], "micrometres");
  EXPECT_NEAR(input["spacing"][2].get<double>(), 1.0, 1e-6);
  EXPECT_NE(m_Errors.find("the NIfTI file is in micrometres"), std::string::npos) << m_Errors;
}

TEST_F(MicroscopyImages, OfScaledNumbersAreReadWhereTheyAreWhole)
{
  this->WriteTissue<short>("a.nii");
  this->ChangeNifti("a.nii", [](nifti_1_header & header) { header.scl_slope = 1.00001f; });
  this->ExpectReference("a.nii");
  this->ChangeNifti("a.nii", [](nifti_1_header & header) { header.scl_slope = 0.3f; });
  this->ExpectRefusal("a.nii walls.vtp", { "a.nii: the voxel at index (", "scaled by scl_slope" });
  const auto image = MakeTissue<float>();
  image->SetPixel({ { 3, 2, 1 } }, 7.25f);
  this->WriteImage(image.GetPointer(), "b.mha");
  this->ExpectRefusal("b.mha walls.vtp", { "index (3, 2, 1) has the value 7.25" });
}
