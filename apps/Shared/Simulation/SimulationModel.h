/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SimulationModel_h
#define SimulationModel_h

#include "Shared/Simulation/CellSolids.h"
#include "TissueTessellationCore/Adjacency/JunctionSet.h"

#include <string>

namespace tissue
{
/** \brief The walls and the volumes between them, for programs that mesh volumes with tetrahedra.
 *
 * Walls keep their points and triangles. Volumes are the cells'; voids, and cells whose surface is not closed, have
 * none. Lengths are those of the mesh. All writers throw std::runtime_error where a file cannot be written. */
class SimulationModel
{
public:
  /** \throws std::invalid_argument: walls of cells that there are not. */
  SimulationModel(const WallMesh & mesh, const std::vector<Cell> & cells);

  /** The triangles as MSH 2.2 of Gmsh: the elementary entity of each is the number of its wall, from 1 on. */
  void
  WriteGmshWalls(const std::string & path) const;

  /** A `.geo` that merges these and makes surface loops and volumes of them, with the physical volumes `cell_L`, whose
   * tag is the label L where that is 1 .. 2^31 - 1, and else a free number, and the physical surfaces `wall_A_B`, of
   * the labels of the two cells, the exterior's last. \param walls the name of the other file, in the same folder. */
  void
  WriteGmshModel(const std::string & path, const std::string & walls) const;

  /** A `.smesh` of TetGen: facets are marked by their walls, from 1 on, voids have holes, cells regions, one for each
   * of its solids, of its label for an attribute. For `tetgen -pqAY`. */
  void
  WriteTetGenModel(const std::string & path) const;

private:
  Label
  LabelOf(VertexId vertex) const;

  const WallMesh &          m_Mesh;
  const std::vector<Cell> & m_Cells;
  CellSolids                m_Solids;
};

/** Whether the name of a model is one of Gmsh: ends in `.geo`. */
bool
IsGmshModel(const std::string & model);

/** The file of the walls beside a `.geo`: the same name with `.msh`. */
std::string
GmshWallsBeside(const std::string & model);
} // namespace tissue

#endif
