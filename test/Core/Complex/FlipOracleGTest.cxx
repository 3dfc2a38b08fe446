/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "RandomMoves.h"
#include "TestComplexes.h"

#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_ds_cell_base_3.h>
#include <CGAL/Triangulation_ds_vertex_base_3.h>
#include <gtest/gtest.h>

#include <map>

using namespace tissue_test;

/** CGAL's combinatorial triangulation as an oracle: its flips 2-3 and 3-2, which check themselves whether they are
 * possible, must agree with ours in verdict and in result. */
namespace
{
using Structure = CGAL::Triangulation_data_structure_3<>;

class Oracle
{
public:
  explicit Oracle(const AdjacencyComplex & complex)
  {
    m_Structure.set_dimension(3);
    for (VertexId v = 0; v < complex.NumberOfVertices(); ++v)
    {
      m_Vertices.push_back(m_Structure.create_vertex());
      m_IdOf[m_Vertices.back()] = v;
    }
    std::vector<Structure::Cell_handle> cells;
    for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
    {
      const auto & t = complex.GetTetrahedron(id).vertices;
      cells.push_back(m_Structure.create_cell(m_Vertices[t[0]], m_Vertices[t[1]], m_Vertices[t[2]], m_Vertices[t[3]]));
    }
    for (TetrahedronId id = 0; id < complex.TetrahedronIdBound(); ++id)
    {
      for (int i = 0; i < 4; ++i)
      {
        cells[id]->set_neighbor(i, cells[complex.GetTetrahedron(id).neighbors[i]]);
        cells[id]->vertex(i)->set_cell(cells[id]);
      }
    }
  }

  bool
  IsValid() const
  {
    return m_Structure.is_valid();
  }

  /** Flips the triangle of `tetrahedron` opposite to its vertex i; false where CGAL finds that impossible. */
  bool
  FlipTriangle(const VertexQuadruple & tetrahedron, int i)
  {
    const auto cell = Find(tetrahedron);
    return m_Structure.flip(cell, cell->index(m_Vertices[tetrahedron[i]]));
  }

  /** Flips the edge of `tetrahedron` between its vertices i and j; likewise. */
  bool
  FlipEdge(const VertexQuadruple & tetrahedron, int i, int j)
  {
    const auto cell = Find(tetrahedron);
    return m_Structure.flip(cell, cell->index(m_Vertices[tetrahedron[i]]), cell->index(m_Vertices[tetrahedron[j]]));
  }

  std::vector<VertexQuadruple>
  GetTetrahedra() const
  {
    std::vector<VertexQuadruple> tetrahedra;
    for (auto cell = m_Structure.cells_begin(); cell != m_Structure.cells_end(); ++cell)
    {
      VertexQuadruple t;
      for (int i = 0; i < 4; ++i)
      {
        t[i] = m_IdOf.at(cell->vertex(i));
      }
      tetrahedra.push_back(Canonical(t));
    }
    std::sort(tetrahedra.begin(), tetrahedra.end());
    return tetrahedra;
  }

private:
  Structure::Cell_handle
  Find(const VertexQuadruple & t) const
  {
    Structure::Cell_handle cell;
    int                    at[4];
    EXPECT_TRUE(m_Structure.is_cell(
      m_Vertices[t[0]], m_Vertices[t[1]], m_Vertices[t[2]], m_Vertices[t[3]], cell, at[0], at[1], at[2], at[3]));
    return cell;
  }

  Structure                                    m_Structure;
  std::vector<Structure::Vertex_handle>        m_Vertices;
  std::map<Structure::Vertex_handle, VertexId> m_IdOf;
};
} // namespace

TEST(FlipOracle, FlipsAgreeWithThoseOfCGAL)
{
  const auto noCost = [](const AdjacencyComplex::Ring &, int, int, int) { return 0.0; };
  int        numbers[2][2] = { { 0, 0 }, { 0, 0 } }; // of swaps and removals, refused and done
  // Removals are refused in small complexes only.
  for (const int numberOfCells : { 5, 25 })
  {
    const auto            centers = RandomCenters(numberOfCells, 1);
    AdjacencyComplex      complex = DelaunayComplex(centers);
    Oracle                oracle(complex);
    const LocalOperations operations(complex, centers, Legality::Combinatorial);
    Random                random(1);
    for (int step = 0; step < 2000; ++step)
    {
      const TetrahedronId   id = RandomTetrahedron(complex, random);
      const VertexQuadruple t = complex.GetTetrahedron(id).vertices;
      const int             i = static_cast<int>(random.Index(4));
      const int             j = (i + 1 + static_cast<int>(random.Index(3))) % 4;
      const bool            isSwap = complex.FindEdge(t[i], t[j])->degree > 3;
      const Proposal        proposal =
        isSwap ? operations.SwapTriangle(id, i) : operations.RemoveEdge({ { t[i], t[j] } }, noCost);
      const bool done = isSwap ? oracle.FlipTriangle(t, i) : oracle.FlipEdge(t, i, j);
      ASSERT_EQ(static_cast<bool>(proposal), done) << "step " << step << ": " << ToString(proposal.verdict);
      if (proposal)
      {
        complex.Apply(proposal.replacement);
        ASSERT_EQ(complex.GetTetrahedra(), oracle.GetTetrahedra()) << "step " << step;
      }
      ++numbers[isSwap ? 0 : 1][done ? 1 : 0];
    }
    EXPECT_TRUE(oracle.IsValid());
  }
  for (const auto & kind : numbers)
  {
    EXPECT_GT(kind[0], 20) << "refused";
    EXPECT_GT(kind[1], 100) << "done";
  }
}
