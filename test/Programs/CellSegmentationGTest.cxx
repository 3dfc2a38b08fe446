/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "Shared/Reconstruction/CellSegmentation.h"

#include "FourCubes.h"
#include "Shared/Files/OutputFiles.h"
#include "Shared/Files/VTKFiles.h"
#include "TemporaryFolder.h"
#include "TissueTessellationVTKBridge.h"

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkFeatureEdges.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkMath.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLMultiBlockDataReader.h>

using namespace tissue;

namespace
{
class CellSegmentationTest : public TemporaryFolderTest
{
protected:
  CellSegmentationTest()
    : m_Check(CheckCellSurfaces(m_Tissue.mesh, static_cast<VertexId>(m_Tissue.cells.size())))
    , m_Grid(MakeCellGrid(m_Tissue.mesh, m_Tissue.cells, m_Check, m_Tissue.Statistics()))
  {
    for (std::size_t v = 1; v < m_Tissue.cells.size(); ++v)
    {
      m_Colors[m_Tissue.cells[v].label] = { { 255, static_cast<unsigned char>(51 * v), 0 } };
    }
  }

  /** The value of a field array as text. */
  static std::string
  TextOf(vtkPolyData * data, const char * name)
  {
    auto * const array = vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name));
    return array != nullptr && array->GetNumberOfValues() == 1 ? array->GetValue(0) : "none";
  }

  FourCubes                            m_Tissue;
  CellSurfaceCheck                     m_Check;
  vtkSmartPointer<vtkUnstructuredGrid> m_Grid;
  std::map<Label, Color>               m_Colors;
};
} // namespace

TEST_F(CellSegmentationTest, IsReadByVTKWithWhatSlicerLooksFor)
{
  const auto  segmentation = MakeCellSegmentation(m_Grid, m_Colors, { { m_Tissue.cells[2].label, "Guard" } });
  OutputFiles files;
  files.AddWithPieces(PathOf("cells.seg.vtm"), [&](const std::string & path) { WriteXML(segmentation, path); });
  files.Commit();
  EXPECT_EQ(List(), "cells.seg cells.seg.vtm ");
  // The names by which Slicer knows the pieces.
  EXPECT_TRUE(std::filesystem::exists(PathOf("cells.seg/cells.seg_3.vtp")));

  const vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName(PathOf("cells.seg.vtm").c_str());
  reader->Update();
  auto * const read = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  ASSERT_NE(read, nullptr);
  ASSERT_EQ(read->GetNumberOfBlocks(), 4u);
  for (unsigned int i = 0; i < 4; ++i)
  {
    auto * const block = vtkPolyData::SafeDownCast(read->GetBlock(i));
    ASSERT_NE(block, nullptr);
    const Cell &      cell = m_Tissue.cells[i + 1];
    const std::string label = std::to_string(cell.label);
    EXPECT_EQ(TextOf(block, "Segmentation_MasterRepresentation"), "Closed surface");
    EXPECT_EQ(TextOf(block, "Segmentation_ContainedRepresentationNames"), "Closed surface|");
    EXPECT_EQ(TextOf(block, "Segment_ID"), "cell_" + label);
    EXPECT_EQ(TextOf(block, "Segment_Name"), i == 1 ? "Guard" : "Cell " + label);
    auto * const color = vtkDoubleArray::SafeDownCast(block->GetFieldData()->GetArray("Segment_Color"));
    ASSERT_NE(color, nullptr);
    EXPECT_EQ(color->GetNumberOfComponents(), 3);
    EXPECT_DOUBLE_EQ(color->GetComponent(0, 0), 1.0);
    EXPECT_DOUBLE_EQ(color->GetComponent(0, 1), 0.2 * (i + 1));
    // The statistics, but for positions, which would be those of other axes.
    ASSERT_NE(block->GetFieldData()->GetArray("Volume"), nullptr);
    EXPECT_DOUBLE_EQ(block->GetFieldData()->GetArray("Volume")->GetTuple1(0), m_Check.cells[i + 1].volume);
    EXPECT_EQ(block->GetFieldData()->GetArray("CenterX"), nullptr);
  }
}

TEST_F(CellSegmentationTest, HasClosedOutwardSurfacesInRas)
{
  const auto segmentation = MakeCellSegmentation(m_Grid, m_Colors, {});
  for (unsigned int i = 0; i < 4; ++i)
  {
    auto * const                  block = vtkPolyData::SafeDownCast(segmentation->GetBlock(i));
    const vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(block);
    edges->BoundaryEdgesOn();
    edges->NonManifoldEdgesOn();
    edges->FeatureEdgesOff();
    edges->ManifoldEdgesOff();
    edges->Update();
    EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0) << i;

    double volume = 0.0;
    double bounds[6];
    double grid[6];
    for (vtkIdType t = 0; t < block->GetNumberOfCells(); ++t)
    {
      const vtkNew<vtkIdList> ids;
      block->GetCellPoints(t, ids);
      double p[3][3];
      for (int k = 0; k < 3; ++k)
      {
        block->GetPoint(ids->GetId(k), p[k]);
      }
      volume += vtkMath::Determinant3x3(p[0], p[1], p[2]) / 6.0;
    }
    EXPECT_NEAR(volume, m_Check.cells[i + 1].volume, 1e-9) << i;
    EXPECT_GT(volume, 0.0) << i;
    block->GetBounds(bounds);
    m_Grid->GetCellBounds(static_cast<vtkIdType>(i), grid);
    EXPECT_DOUBLE_EQ(bounds[0], -grid[1]);
    EXPECT_DOUBLE_EQ(bounds[2], -grid[3]);
    EXPECT_DOUBLE_EQ(bounds[4], grid[4]);
  }
}
