/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef Projection_h
#define Projection_h

#include "Shared/Projection/ProjectionSources.h"
#include "TissueTessellationVTK/ProjectedData.h"
#include "itkCellWallMesh.h"
#include "itkTissueLabelVolume.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace tissue
{
/** \brief Projects tables and images on the cells of a tissue, and on its walls.
 *
 * Made before the mesh is, so that what cannot be projected is known before the long work. */
class Projection
{
public:
  /** \param cells of the tissue, with the exterior. \param names of their labels, where the cells have some.
   * \param labels of the voxels; null where there are none: then there can be no signals.
   * \throws FileError: a table without a row of a cell, an image that has none of the cells' voxels, or lengths in
   * another unit. */
  Projection(ProjectionSources sources, double wallDistance, const std::vector<Cell> & cells,
             const std::map<Label, std::string> & names, itk::TissueLabelVolume::Pointer labels,
             const std::string & unit);

  /** Values of the cells, and of the walls of their mesh. To be called once: the images are freed. */
  ProjectedData
  Project(const itk::CellWallMesh * mesh, ProgressBar & progress);

  /** What is to be said of files and cells; complete after Project(). */
  const std::vector<std::string> &
  GetWarnings() const
  {
    return m_Warnings;
  }

  /** For the report, `cellData` and `signals`; complete after Project(), empty where nothing is projected. */
  const nlohmann::ordered_json &
  GetReport() const
  {
    return m_Report;
  }

private:
  void
  MatchTables(const std::vector<Cell> & cells, const std::map<Label, std::string> & names);

  void
  ProjectTables(ProjectedData & data) const;

  void
  ProjectSignal(const ProjectionSources::Signal & signal, const itk::CellWallMesh * mesh, ProjectedData & data);

  ProjectionSources               m_Sources;
  double                          m_WallDistance;
  itk::TissueLabelVolume::Pointer m_Labels;
  std::vector<MatchedRows>        m_Rows;
  std::vector<std::string>        m_Warnings;
  nlohmann::ordered_json          m_Report = nlohmann::ordered_json::object();
};
} // namespace tissue

#endif
