/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
// What is refused: by one line on standard error and exit code 1, and no output is left.
#include "LabelImageTestHelpers.h"
#include "TissueTessellationProgramTest.h"

#include <fstream>

namespace
{
class TissueTessellationAppErrors : public TissueTessellationAppTest
{
protected:
  /** Shortens a file of an image by a part of its size. */
  void
  ExpectRefusalOfCutFile(const std::string & name, const std::string & part)
  {
    const std::string bytes = ReadBytes(this->PathOf(name));
    for (const double fraction : { 0.5, 0.98 })
    {
      std::ofstream(this->PathOf(name), std::ios::binary) << bytes.substr(0, fraction * bytes.size());
      this->ExpectRefusal(name + " walls.vtp", { name + ": ", part });
    }
  }

  template <typename TFunction>
  void
  WriteLabels(const std::string & name, TFunction labelOf)
  {
    this->WriteImage(tissue_test::MakeImage<unsigned char>({ { 20, 20, 20 } }, labelOf).GetPointer(), name);
  }
};
} // namespace

TEST_F(TissueTessellationAppErrors, FilesThatAreNoImages)
{
  this->ExpectRefusal("none.mha walls.vtp", { "none.mha: no such file" });
  this->ExpectRefusal(". walls.vtp", { ".: a folder" });
  for (const char * name : { "text.mha", "text.nrrd", "text.nii.gz", "text.tif", "text.txt" })
  {
    std::ofstream(this->PathOf(name)) << "Dear reader,\n";
    this->ExpectRefusal(std::string(name) + " walls.vtp", { name, "not an image in a format that ITK reads" });
  }
  std::ofstream(this->PathOf("empty.mha"));
  this->ExpectRefusal("empty.mha walls.vtp", { "empty.mha: not an image" });
}

TEST_F(TissueTessellationAppErrors, PlacesThatNoImageCanHave)
{
  const auto write = [this](const std::string & line) {
    this->WriteLines("a.mha",
                     "ObjectType = Image\nNDims = 3\nDimSize = 4 4 4\nElementType = MET_UCHAR\n" + line +
                       "\nElementDataFile = LOCAL\n" + std::string(64, '\1'));
  };
  for (const char * line : { "Offset = 1e308 0 0",
                             "Offset = 0 0 2e9",
                             "Offset = 0 -2e12 0\nElementSpacing = 1e6 1e6 1e6",
                             "TransformMatrix = 1e9 0 0 0 1 0 0 0 1" })
  {
    write(line);
    this->ExpectRefusal("a.mha walls.vtp", { "a.mha: the header has an origin, " });
  }
  for (const char * line : { "ElementSpacing = 0 1 1", "ElementSpacing = 1 1 1e300", "ElementSpacing = 1 -1 1" })
  {
    write(line);
    this->ExpectRefusal("a.mha walls.vtp", { "a.mha: " });
  }
}

TEST_F(TissueTessellationAppErrors, FilesThatAreCutOff)
{
  this->WriteTissue<unsigned short>("a.mha");
  this->WriteTissue<unsigned short>("b.mha", true);
  this->WriteTissue<unsigned short>("c.nrrd");
  this->WriteTissue<unsigned short>("d.nrrd", true);
  this->WriteTissue<unsigned short>("e.nii");
  this->WriteTissue<unsigned short>("f.nii.gz", true);
  this->WriteTissue<unsigned short>("g.tif");
  this->WriteTissue<unsigned short>("h.vtk");
  this->WriteTissue<unsigned short>("i.gipl");
  this->ExpectRefusalOfCutFile("a.mha", "cut off or broken");
  this->ExpectRefusalOfCutFile("b.mha", "cut off or broken");
  this->ExpectRefusalOfCutFile("c.nrrd", "cut off or broken");
  this->ExpectRefusalOfCutFile("d.nrrd", "Error reading");
  this->ExpectRefusalOfCutFile("e.nii", "the file is cut off: it holds ");
  this->ExpectRefusalOfCutFile("f.nii.gz", "the file is cut off: it holds ");
  this->ExpectRefusalOfCutFile("g.tif", "cut off or broken");
  this->ExpectRefusalOfCutFile("h.vtk", "the file is cut off: it holds ");
  this->ExpectRefusalOfCutFile("i.gipl", "the file is cut off: it holds ");
  this->WriteTissue<unsigned short>("j.mhd");
  std::filesystem::remove(this->PathOf("j.raw"));
  this->ExpectRefusal("j.mhd walls.vtp", { "j.mhd: its file of voxels, 'j.raw', is not there" });
}

TEST_F(TissueTessellationAppErrors, ImagesThatAreNoLabelImages)
{
  const auto flat = itk::Image<unsigned char, 2>::New();
  flat->SetRegions(itk::Size<2>{ { 8, 8 } });
  flat->Allocate(true);
  this->WriteImage(flat.GetPointer(), "flat.mha");
  this->ExpectRefusal("flat.mha walls.vtp", { "flat.mha: the image has 2 dimensions, a label image has 3" });
  const auto colored = itk::Image<itk::Vector<unsigned char, 3>, 3>::New();
  colored->SetRegions(itk::Size<3>{ { 8, 8, 8 } });
  colored->Allocate(true);
  this->WriteImage(colored.GetPointer(), "colored.mha");
  this->ExpectRefusal("colored.mha walls.vtp", { "the file has 3 channels, of which one is read: --channel 1 to 3" });
  const auto floating = itk::Image<float, 3>::New();
  floating->SetRegions(itk::Size<3>{ { 8, 8, 8 } });
  floating->Allocate();
  floating->FillBuffer(0.5f);
  this->WriteImage(floating.GetPointer(), "float.mha");
  this->ExpectRefusal("float.mha walls.vtp", { "the voxel at index (0, 0, 0) has the value 0.5" });
}

TEST_F(TissueTessellationAppErrors, ImagesThatAreNoTissue)
{
  const auto isInside = [](long x, long y) { return x >= 4 && x < 16 && y >= 4 && y < 16; };
  this->WriteLabels("none.mha", [](long, long, long) { return 0; });
  this->ExpectRefusal("none.mha walls.vtp", { "none.mha: ", "The image has no cell" });
  this->WriteLabels("three.mha", [&](long x, long y, long) { return isInside(x, y) ? x / 4 : 0; });
  this->ExpectRefusal("three.mha walls.vtp --preset paper", { "three.mha: ", "3 cells, at least 4 are needed" });
  const auto nineInAPlane = [&](long x, long y, long z) {
    return isInside(x, y) && z >= 8 && z < 12 ? x / 4 + 3 * (y / 4 - 1) : 0;
  };
  this->WriteLabels("plane.mha", nineInAPlane);
  this->ExpectRefusal("plane.mha walls.vtp --preset paper", { "plane.mha: all 9 cell centres are coplanar" });
  this->WriteTissue<unsigned char>("tissue.mha");
  this->ExpectRefusal("tissue.mha walls.vtp --exteriorLabel 99", { "tissue.mha: The exterior label 99" });
  this->ExpectRefusal("tissue.mha walls.vtp --exteriorLabel 300 --closeGaps", { "exterior label 300" });
  this->ExpectRefusal("tissue.mha walls.vtp --zeroIsCell --closeGaps", { "no background to close gaps in" });

  const auto image = MakeSyntheticTestTissue<unsigned long long>();
  image->SetPixel({ { 20, 20, 9 } }, 1ull << 63);
  this->WriteImage(image.GetPointer(), "large.mha");
  this->ExpectRefusal("large.mha walls.vtp", { "Label 9223372036854775808 is above the limit of 9223372036854775807" });
}

TEST_F(TissueTessellationAppErrors, OutputsThatCannotBeWritten)
{
  this->WriteTissue<unsigned char>("tissue.mha");
  this->ExpectRefusal("tissue.mha none/walls.vtp", { "'none/walls.vtp': there is no folder" });
  this->ExpectRefusal("tissue.mha walls.vtp --report none/r.json", { "'none/r.json': there is no folder" });
  std::filesystem::create_directory(this->PathOf("folder.vtp"));
  this->ExpectRefusal("tissue.mha folder.vtp", { "'folder.vtp': it is a folder" });
  std::filesystem::create_symlink("/dev/full", this->PathOf("full.vtp"));
  this->ExpectRefusal("tissue.mha full.vtp", { "'full.vtp': it is not a regular file" });
  this->ExpectRefusal("tissue.mha /proc/walls.vtp", { "Cannot write '/proc/walls.vtp'" });
  this->ExpectRefusal("tissue.mha walls.stl", { "'walls.stl', must end in .vtp" });
  this->ExpectRefusal("tissue.mha walls.vtp --report report.txt", { "--report", "must end in .json" });
  this->ExpectRefusal("tissue.mha walls.vtp --complex a.vtu --cells ./a.vtu", { "'./a.vtu': another output" });
  std::filesystem::rename(this->PathOf("tissue.mha"), this->PathOf("tissue.vtp"));
  this->ExpectRefusal("tissue.vtp tissue.vtp", { "'tissue.vtp': it is the input" });
}

TEST_F(TissueTessellationAppErrors, OutputsThatWouldReplaceTheVoxelsOfAnInput)
{
  this->WriteTissue<unsigned char>("tissue.mhd");
  std::filesystem::rename(this->PathOf("tissue.raw"), this->PathOf("tissue.vtp"));
  std::string header = ReadBytes(this->PathOf("tissue.mhd"));
  header.replace(header.rfind("raw"), 3, "vtp");
  std::ofstream(this->PathOf("tissue.mhd"), std::ios::binary) << header;
  const std::string voxels = ReadBytes(this->PathOf("tissue.vtp"));
  this->ExpectRefusal("tissue.mhd tissue.vtp", { "'tissue.vtp': it holds the voxels of the input 'tissue.mhd'" });
  EXPECT_EQ(ReadBytes(this->PathOf("tissue.vtp")), voxels);
  EXPECT_EQ(this->Run("tissue.mhd walls.vtp --refinement 0"), 0) << m_Errors;
}

TEST_F(TissueTessellationAppErrors, DisksThatRunFull)
{
  this->WriteTissue<unsigned char>("tissue.mha");
  // Files may have 8 blocks of 512 bytes.
  this->ExpectRefusal("tissue.mha walls.vtp", { "Cannot write 'walls.vtp': " }, "ulimit -f 8 &&");
}

TEST_F(TissueTessellationAppErrors, PicturesWithoutADisplayBeforeAnyWork)
{
  this->ExpectRefusal("none.mha walls.vtp --picture a.png",
                      { "--picture: ", "xvfb-run -a" },
                      "unset DISPLAY && __EGL_VENDOR_LIBRARY_FILENAMES=/none");
}

TEST_F(TissueTessellationAppErrors, OptionsThatAreUnknownOrOutOfRange)
{
  this->WriteTissue<unsigned char>("tissue.mha");
  this->ExpectRefusal("", { "labels is required" });
  this->ExpectRefusal("tissue.mha", { "walls is required" });
  const std::map<std::string, std::string> messages{
    { "--unknown", "--unknown" },
    { "more.vtp", "more.vtp" },
    { "--preset paper --seed -1", "--seed: -1 is out of range, must be in 0 .. " },
    { "--threads 5000", "--threads: 5000 is out of range, must be in 0 .. 1024" },
    { "--spacing 1 1", "--spacing: 3 required" },
    { "--spacing 1 1 0", "--spacing: 0 is out of range, must be in 1e-12 .. 1e+12" },
    { "--spacing 1 nan 1", "--spacing: nan is out of range" },
    { "--closeGaps=-1", "--closeGaps: -1 is out of range, must be in 0 .. 1e+12" },
    { "--exteriorLabel 1.5", "--exteriorLabel = 1.5" },
    { "--preset best", "--preset: best not in {default,paper}" },
    { "--preset paper --legality legal", "--legality: legal not in {combinatorial,geometric}" },
    { "--refinement 4", "--refinement: 4 is out of range, must be in 0 .. 3" },
    { "--preset paper --numberOfCycles -1", "--numberOfCycles: -1 is out of range, must be in 0 .. 1000" },
    { "--preset paper --smoothingIterations -1", "--smoothingIterations: -1 is out of range, must be in 0 .. 10000" },
    { "--preset paper --maximumEdgeLength nan", "--maximumEdgeLength: nan is out of range, must be in 0 .. " },
    { "--triangles 5", "--triangles: 5 is out of range, must be in 40 .. 10000" },
    { "--triangles \"\"", "--triangles" },
    { "--triangles many", "--triangles" },
    { "--preset paper --coolingFactor 2", "--coolingFactor: 2 is out of range, must be in 1e-09 .. 1" },
    { "--numberOfCycles 3", "--numberOfCycles: only with --preset paper" },
    { "--legality geometric", "--legality: only with --preset paper" },
    { "--localMaximumEdgeLength true", "--localMaximumEdgeLength: only with --preset paper" },
    { "--preset paper --triangles 100", "--triangles: not with --preset paper" },
    { "--prefer walls --preset paper", "--prefer: not with --preset paper" },
  };
  for (const auto & [option, message] : messages)
  {
    this->ExpectRefusal("tissue.mha walls.vtp " + option, { message });
  }
}
