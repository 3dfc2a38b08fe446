/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Page/PageFile.h"

#include "TableFromLists.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <vtkBase64Utilities.h>
#include <vtkStringArray.h>
#include <vtkTypeFloat64Array.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>
#include <vtkTypeUInt8Array.h>

#include <cmath>
#include <cstring>
#include <limits>

namespace
{
template <typename TValue>
std::vector<TValue>
FromBase64(const std::string & text)
{
  std::vector<unsigned char> bytes(text.size());
  const std::size_t          size = vtkBase64Utilities::DecodeSafely(
    reinterpret_cast<const unsigned char *>(text.data()), text.size(), bytes.data(), bytes.size());
  std::vector<TValue> values(size / sizeof(TValue));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(TValue));
  return values;
}

/** Two tetrahedra that share a triangle, far from the origin. */
tissue::WallMesh
MakeTwoCells()
{
  tissue::WallMesh mesh;
  mesh.points = { { { 1000, 0, 0 } }, { { 1001, 0, 0 } }, { { 1000, 1, 0 } }, { { 1000, 0, 1 } }, { { 1000, 0, -1 } } };
  mesh.walls = { { { { 1, 2 } } }, { { { 1, 0 } } }, { { { 2, 0 } } } };
  mesh.triangles = { { { 0, 2, 1 } }, { { 0, 1, 3 } }, { { 1, 2, 3 } }, { { 2, 0, 3 } },
                     { { 1, 0, 4 } }, { { 2, 1, 4 } }, { { 0, 2, 4 } } };
  mesh.wallOfTriangle = { 0, 1, 1, 1, 2, 2, 2 };
  return mesh;
}

class PageFileTest : public TemporaryFolderTest
{
protected:
  PageFileTest()
  {
    AddColumn<vtkTypeInt64Array, std::int64_t>(m_Cells, "Label", { 7, 9007199254740993 });
    AddColumn<vtkTypeFloat64Array, double>(m_Cells, "Volume", { 0.5, std::numeric_limits<double>::quiet_NaN() });
    AddColumn<vtkTypeInt32Array, int>(m_Cells, "Layer", { 1, 2 });
    AddColumn<vtkTypeInt32Array, int>(m_Cells, "NumberOfNeighbors", { 1, 1 });
    AddColumn<vtkTypeUInt8Array, unsigned char>(m_Cells, "IsClosed", { 1, 0 });
  }

  tissue::PageContent
  Content() const
  {
    return { m_Mesh, m_Cells, m_Colors, m_Report, "micrometres" };
  }

  nlohmann::json
  Data() const
  {
    return nlohmann::json::parse(tissue::MakePageData(this->Content()));
  }

  tissue::WallMesh           m_Mesh = MakeTwoCells();
  vtkNew<vtkTable>           m_Cells;
  std::vector<tissue::Color> m_Colors = { { { 0, 0, 0 } }, { { 1, 2, 3 } }, { { 4, 5, 255 } } };
  nlohmann::ordered_json     m_Report = { { "program", "none" } };
};
} // namespace

TEST_F(PageFileTest, MeshIsThereWithTheRowsOfTheCellsOfEachWall)
{
  const nlohmann::json data = this->Data();
  EXPECT_EQ(data["unit"], "µm");
  EXPECT_EQ(data["origin"], nlohmann::json({ 1000.5, 0.5, 0.0 }));
  const auto points = FromBase64<float>(data["points"]);
  ASSERT_EQ(points.size(), 15u);
  EXPECT_EQ(points[3], 0.5f);
  EXPECT_EQ(points[14], -1.0f);
  const auto triangles = FromBase64<std::uint32_t>(data["triangles"]);
  ASSERT_EQ(triangles.size(), 21u);
  EXPECT_EQ(triangles[1], 2u);
  EXPECT_EQ(FromBase64<std::uint32_t>(data["walls"]), (std::vector<std::uint32_t>{ 1, 2, 1, 1, 0, 3, 2, 0, 3 }));
  EXPECT_EQ(FromBase64<std::uint8_t>(data["colors"]), (std::vector<std::uint8_t>{ 1, 2, 3, 4, 5, 255 }));
}

TEST_F(PageFileTest, ColumnsHaveTheirKindsAndUnits)
{
  const nlohmann::json columns = this->Data()["columns"];
  ASSERT_EQ(columns.size(), 5u);
  EXPECT_EQ(columns[0]["kind"], "label");
  EXPECT_EQ(columns[0]["values"], nlohmann::json({ "7", "9007199254740993" }));
  EXPECT_EQ(columns[1]["kind"], "number");
  EXPECT_EQ(columns[1]["unit"], "µm³");
  const auto volumes = FromBase64<float>(columns[1]["values"]);
  ASSERT_EQ(volumes.size(), 2u);
  EXPECT_EQ(volumes[0], 0.5f);
  EXPECT_TRUE(std::isnan(volumes[1]));
  EXPECT_EQ(columns[2]["kind"], "category");
  EXPECT_EQ(columns[3]["kind"], "count");
  EXPECT_EQ(columns[3]["unit"], "");
  EXPECT_EQ(columns[4]["kind"], "flag");
  EXPECT_EQ(columns[4]["values"], nlohmann::json({ 1, 0 }));
}

TEST_F(PageFileTest, NoTextEndsTheElementOfTheData)
{
  const char * const name = "</script><!--<script>\xE2\x80\xA8&\"'\\ é";
  AddColumn<vtkStringArray, const char *>(m_Cells, "Name", { name, "of no encoding: \xFF" });
  m_Report["input"]["file"] = name;
  const std::string text = tissue::MakePageData(this->Content());
  for (const char c : text)
  {
    ASSERT_TRUE(c >= ' ' && c <= '~' && c != '<') << c;
  }
  const nlohmann::json data = nlohmann::json::parse(text);
  EXPECT_EQ(data["columns"][5]["kind"], "text");
  EXPECT_EQ(data["columns"][5]["values"], nlohmann::json({ name, "of no encoding: \xEF\xBF\xBD" }));
  EXPECT_EQ(data["report"]["input"]["file"], name);
}

TEST_F(PageFileTest, PageIsSmallHasTheLicencesAndLoadsNothing)
{
  tissue::WritePage(this->Content(), PathOf("page.html"));
  const std::string page = ReadBytes(PathOf("page.html"));
  EXPECT_LT(page.size(), 600000u);
  EXPECT_EQ(page.find("<!DOCTYPE html>"), 0u);
  EXPECT_EQ(page.substr(page.size() - 8), "</html>\n");
  EXPECT_NE(page.find("<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "),
            std::string::npos);
  for (const char * const notice : { "Copyright (c) 2016, Kitware Inc.", "gl-matrix", "Apache-2.0", "David Bau" })
  {
    EXPECT_NE(page.find(notice), std::string::npos) << notice;
  }
  for (const char * const load :
       { " src=", "<link", "@import", "url(http", "import(", "@TISSUE_DATA@", "sourceMappingURL" })
  {
    EXPECT_EQ(page.find(load), std::string::npos) << load;
  }
  const std::string begin = "<script type=\"application/json\" id=\"tissue-data\">";
  const std::size_t at = page.find(begin) + begin.size();
  const auto        data = nlohmann::json::parse(page.substr(at, page.find("</script>", at) - at));
  EXPECT_EQ(data, this->Data());
}

TEST_F(PageFileTest, OtherNumbersOfColoursOrCellsAreRefused)
{
  m_Colors.pop_back();
  EXPECT_THROW(tissue::MakePageData(this->Content()), std::invalid_argument);
  m_Colors.push_back({ { 0, 0, 0 } });
  m_Mesh.walls[0].cells[1] = 3;
  EXPECT_THROW(tissue::MakePageData(this->Content()), std::invalid_argument);
}
