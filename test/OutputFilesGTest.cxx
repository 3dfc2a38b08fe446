/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "OutputFiles.h"

#include "FourCubes.h"
#include "TissueTessellationVTKBridge.h"

#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

#ifdef __unix__
#  include <csignal>
#  include <sys/resource.h>
#endif

namespace
{
namespace fs = std::filesystem;

std::string
ReadBytes(const fs::path & path)
{
  std::ifstream      file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return bytes.str();
}

void
WriteText(const std::string & path)
{
  std::ofstream(path) << "new";
}

/** A new empty folder for each test, removed after it. */
class OutputFilesTest : public testing::Test
{
protected:
  void
  SetUp() override
  {
    const std::string name = testing::UnitTest::GetInstance()->current_test_info()->name();
    m_Folder = fs::temp_directory_path() / ("TissueTessellationOutputFiles" + name);
    fs::remove_all(m_Folder);
    fs::create_directory(m_Folder);
  }
  void
  TearDown() override
  {
    fs::remove_all(m_Folder);
  }

  std::string
  PathOf(const std::string & name) const
  {
    return (m_Folder / name).string();
  }

  /** Names of all that is in the folder, hidden files too. */
  std::string
  List() const
  {
    std::set<std::string> names;
    for (const auto & entry : fs::directory_iterator(m_Folder))
    {
      names.insert(entry.path().filename().string());
    }
    std::string list;
    for (const std::string & name : names)
    {
      list += name + " ";
    }
    return list;
  }

  std::string
  RefusalOf(const std::string & path) const
  {
    try
    {
      tissue::OutputFiles::RequireWritable(path);
    }
    catch (const std::runtime_error & error)
    {
      return error.what();
    }
    return "accepted";
  }

  fs::path        m_Folder;
  const FourCubes m_Tissue;
};
} // namespace

TEST_F(OutputFilesTest, FilesAppearWithCommitAndWithTheirExtensions)
{
  tissue::OutputFiles files;
  std::string         temporaryPath;
  files.Add(PathOf("a.vtp"), [&](const std::string & path) {
    temporaryPath = path;
    WriteText(path);
  });
  files.Add(PathOf("b.csv"), WriteText);
  EXPECT_EQ(fs::path(temporaryPath).extension(), ".vtp");
  EXPECT_EQ(fs::path(temporaryPath).parent_path(), fs::canonical(m_Folder));
  EXPECT_FALSE(fs::exists(PathOf("a.vtp")));
  files.Commit();
  EXPECT_EQ(List(), "a.vtp b.csv ");
  EXPECT_EQ(ReadBytes(PathOf("a.vtp")), "new");
}

TEST_F(OutputFilesTest, NothingIsLeftAndNothingReplacedWhenOneFails)
{
  std::ofstream(PathOf("a.vtp")) << "old";
  try
  {
    tissue::OutputFiles files;
    files.Add(PathOf("a.vtp"), WriteText);
    files.Add(PathOf("b.csv"), [](const std::string &) { throw std::runtime_error("no ink"); });
    FAIL() << "the error of the writer is lost";
  }
  catch (const std::runtime_error & error)
  {
    EXPECT_EQ(error.what(), "Cannot write '" + PathOf("b.csv") + "': no ink");
  }
  EXPECT_EQ(List(), "a.vtp ");
  EXPECT_EQ(ReadBytes(PathOf("a.vtp")), "old");
}

TEST_F(OutputFilesTest, AnOldFileIsReplacedAndALinkKept)
{
  std::ofstream(PathOf("target.vtp")) << "old";
  fs::create_symlink("target.vtp", PathOf("link.vtp"));
  tissue::OutputFiles files;
  files.Add(PathOf("link.vtp"), WriteText);
  EXPECT_THROW(files.Add(PathOf("target.vtp"), WriteText), std::runtime_error);
  files.Commit();
  EXPECT_TRUE(fs::is_symlink(PathOf("link.vtp")));
  EXPECT_EQ(ReadBytes(PathOf("target.vtp")), "new");
  EXPECT_EQ(List(), "link.vtp target.vtp ");
}

TEST_F(OutputFilesTest, PathsThatCannotBeWrittenAreRefusedByReason)
{
  EXPECT_EQ(RefusalOf(PathOf("a.vtp")), "accepted");
  EXPECT_EQ(List(), "");
  EXPECT_NE(RefusalOf(PathOf("none/a.vtp")).find("there is no folder"), std::string::npos);
  EXPECT_NE(RefusalOf(m_Folder.string()).find("it is a folder"), std::string::npos);
  EXPECT_NE(RefusalOf("").find("Cannot write ''"), std::string::npos);
  const fs::path before = fs::current_path();
  fs::current_path(m_Folder);
  EXPECT_EQ(RefusalOf("relative.vtp"), "accepted");
  fs::current_path(before);
#ifdef __unix__
  EXPECT_NE(RefusalOf("/dev/null").find("it is not a regular file"), std::string::npos);
  EXPECT_NE(RefusalOf("/proc/a.vtp").find("Cannot write '/proc/a.vtp': "), std::string::npos);
#endif
}

TEST_F(OutputFilesTest, WallsReadBackAsTheyWere)
{
  const auto walls = tissue::MakeWallPolyData(m_Tissue.mesh, m_Tissue.cells);
  tissue::WriteXML(walls, PathOf("a.vtp"));
  tissue::WriteXML(walls, PathOf("b.vtp"));
  EXPECT_EQ(ReadBytes(PathOf("a.vtp")), ReadBytes(PathOf("b.vtp")));
  EXPECT_NE(ReadBytes(PathOf("a.vtp")).find("vtkZLibDataCompressor"), std::string::npos);

  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(PathOf("a.vtp").c_str());
  reader->Update();
  vtkPolyData * read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfPoints(), 18);
  ASSERT_EQ(read->GetNumberOfPolys(), 40);
  EXPECT_STREQ(read->GetCellData()->GetScalars()->GetName(), "Label");
  for (const char * name : { "Label", "BoundaryLabels", "WallId", "WallArea" })
  {
    vtkDataArray * expected = walls->GetCellData()->GetArray(name);
    vtkDataArray * array = read->GetCellData()->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetDataType(), expected->GetDataType()) << name;
    ASSERT_EQ(array->GetNumberOfValues(), expected->GetNumberOfValues()) << name;
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      EXPECT_EQ(array->GetVariantValue(i), expected->GetVariantValue(i)) << name;
    }
  }
  EXPECT_NE(read->GetPointData()->GetArray("NumberOfCells"), nullptr);
  auto * space = vtkStringArray::SafeDownCast(read->GetFieldData()->GetAbstractArray("SPACE"));
  ASSERT_NE(space, nullptr);
  EXPECT_EQ(space->GetValue(0), "LPS");
}

TEST_F(OutputFilesTest, PolyhedraReadBackAsTheyWere)
{
  const auto check = tissue::CheckCellSurfaces(m_Tissue.mesh, 5);
  tissue::WriteXML(tissue::MakeCellGrid(m_Tissue.mesh, m_Tissue.cells, check), PathOf("a.vtu"));
  vtkNew<vtkXMLUnstructuredGridReader> reader;
  reader->SetFileName(PathOf("a.vtu").c_str());
  reader->Update();
  ASSERT_EQ(reader->GetOutput()->GetNumberOfCells(), 4);
  EXPECT_EQ(reader->GetOutput()->GetCellType(3), VTK_POLYHEDRON);
  EXPECT_EQ(reader->GetOutput()->GetCell(3)->GetNumberOfFaces(), 12);
  EXPECT_EQ(reader->GetOutput()->GetCellData()->GetArray("NumberOfVoxels")->GetComponent(3, 0), 1004.0);
}

TEST_F(OutputFilesTest, TheTableIsCommaSeparatedWithExactNumbers)
{
  FourCubes tissue;
  tissue.cells[1].center[0] = 123456.78901234567;
  const auto check = tissue::CheckCellSurfaces(tissue.mesh, 5);
  tissue::WriteCSV(tissue::MakeCellTable(tissue.mesh, tissue.cells, check), PathOf("a.csv"));
  std::ifstream file(PathOf("a.csv"));
  std::string   header;
  std::string   row;
  std::getline(file, header);
  std::getline(file, row);
  EXPECT_EQ(header,
            "Label,CenterX,CenterY,CenterZ,Volume,ImageVolume,SurfaceArea,NumberOfNeighbors,NumberOfTriangles,"
            "EulerCharacteristic,IsClosed,TouchesExterior,TouchesBorder,NumberOfPieces,NumberOfVoxels,"
            "NumberOfStrayVoxels");
  EXPECT_EQ(row, "10,123456.78901234567,0.5,0.5,1,0.875,6,2,12,2,1,1,0,1,1001,0");
}

#ifdef __unix__
TEST_F(OutputFilesTest, AFullDiskIsAnErrorAndLeavesNothing)
{
  // A limit on the size of files stands for the full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before;
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit small = before;
  small.rlim_cur = 100;
  const auto walls = tissue::MakeWallPolyData(m_Tissue.mesh, m_Tissue.cells);
  const auto check = tissue::CheckCellSurfaces(m_Tissue.mesh, 5);
  const auto table = tissue::MakeCellTable(m_Tissue.mesh, m_Tissue.cells, check);
  setrlimit(RLIMIT_FSIZE, &small);
  std::vector<std::string> errors;
  for (const std::string name : { "a.vtp", "a.csv" })
  {
    try
    {
      tissue::OutputFiles files;
      files.Add(PathOf(name), [&](const std::string & path) {
        name == "a.vtp" ? tissue::WriteXML(walls, path) : tissue::WriteCSV(table, path);
      });
    }
    catch (const std::runtime_error & error)
    {
      errors.push_back(error.what());
    }
  }
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_EQ(List(), "");
  ASSERT_EQ(errors.size(), 2u);
  EXPECT_EQ(errors[0], "Cannot write '" + PathOf("a.vtp") + "': File too large");
  EXPECT_EQ(errors[1], "Cannot write '" + PathOf("a.csv") + "': File too large");
}
#endif
