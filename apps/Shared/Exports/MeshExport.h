/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef MeshExport_h
#define MeshExport_h

#include "TissueTessellationCore/Adjacency/JunctionSet.h"
#include "TissueTessellationCore/Mesh/WallMesh.h"
#include "TissueTessellationVTK/ProjectedData.h"

#include <string>
#include <vector>

namespace tissue
{
/** \brief The ends of the names that ExportMesh() knows:
 *
 * - `.mgx.ply`: the cells' surfaces, for MorphoGraphX: `label` of each face, and of each vertex that of its faces;
 * - `.ply`: the walls, for cellcomplex of OpenAlea: vertices, triangles, edges with the faces at them, and volumes,
 * which are the cells, with their faces and their `label`. It is all of the tissue, whatever cells are chosen;
 * - `.glb`: glTF 2.0 in one file: a node `cell_L` of each cell of label L, in a colour of its own, all of them in a
 *   node `tissue` at the middle of the tissue;
 * - `.obj`: Wavefront, a group `cell_L` each;
 * - `.stl`: binary, the triangles alone.
 *
 * Coordinates are those of the mesh (LPS), in double precision in text, in single precision in `.glb` and `.stl`. */
std::vector<std::string>
MeshExportEndings();

/** Writes a mesh in the format of the name of `format`. \param path the file; its name may be another one.
 * \param labels the cells to write; all where there are none. \param data for `.ply`, which has numbers of walls and
 * cells.
 * \throws std::runtime_error: a label that no cell has, a label beyond 32 bits in a `.ply`, a file that cannot be
 * written; std::invalid_argument: another ending. */
void
ExportMesh(const WallMesh & mesh, const std::vector<Cell> & cells, const std::vector<Label> & labels,
           const ProjectedData & data, const std::string & format, const std::string & path);
} // namespace tissue

#endif
