/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Files/GraphFile.h"

#include "TableFromLists.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <vtkStringArray.h>
#include <vtkTypeFloat64Array.h>
#include <vtkTypeInt64Array.h>

#include <limits>

namespace
{
class GraphFileTest : public TemporaryFolderTest
{};
} // namespace

TEST_F(GraphFileTest, NodesAndEdgesHaveTheirAttributesUnlessTheyAreNotKnown)
{
  vtkNew<vtkTable> nodes;
  AddColumn<vtkTypeInt64Array, std::int64_t>(nodes, "Label", { 3, -5 });
  AddColumn<vtkTypeFloat64Array, double>(nodes, "Volume", { 0.5, std::numeric_limits<double>::quiet_NaN() });
  AddColumn<vtkStringArray, const char *>(nodes, "Name", { "<a & \"b\">", "c\x01" });
  vtkNew<vtkTable> edges;
  AddColumn<vtkTypeInt64Array, std::int64_t>(edges, "Label0", { -5 });
  AddColumn<vtkTypeInt64Array, std::int64_t>(edges, "Label1", { 3 });
  AddColumn<vtkTypeFloat64Array, double>(edges, "weight", { 2.25 });
  tissue::WriteGraphML(nodes, edges, PathOf("g.graphml"));
  EXPECT_EQ(ReadBytes(PathOf("g.graphml")),
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<graphml xmlns=\"http://graphml.graphdrawing.org/xmlns\">\n"
            "  <key id=\"n0\" for=\"node\" attr.name=\"Label\" attr.type=\"long\"/>\n"
            "  <key id=\"n1\" for=\"node\" attr.name=\"Volume\" attr.type=\"double\"/>\n"
            "  <key id=\"n2\" for=\"node\" attr.name=\"Name\" attr.type=\"string\"/>\n"
            "  <key id=\"e0\" for=\"edge\" attr.name=\"weight\" attr.type=\"double\"/>\n"
            "  <graph edgedefault=\"undirected\">\n"
            "    <node id=\"3\"><data key=\"n0\">3</data><data key=\"n1\">0.5</data>"
            "<data key=\"n2\">&lt;a &amp; &quot;b&quot;&gt;</data></node>\n"
            "    <node id=\"-5\"><data key=\"n0\">-5</data><data key=\"n2\">c </data></node>\n"
            "    <edge source=\"-5\" target=\"3\"><data key=\"e0\">2.25</data></edge>\n"
            "  </graph>\n"
            "</graphml>\n");
}
