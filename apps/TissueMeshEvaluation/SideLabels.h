/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef SideLabels_h
#define SideLabels_h

#include "TissueTessellationCore/Common/Types.h"

#include <vtkDataSet.h>

#include <array>
#include <string>
#include <vector>

namespace tissue
{
/** The labels that a mesh gives its polygons. */
struct SideLabels
{
  /** Of each VTK cell: on both sides, or of the cell that it is of the surface of, or is, in the first place. */
  std::vector<std::array<Label, 2>> labels;
  bool                              areOfBothSides = true;
  /** The arrays that they are from, for messages. */
  std::string name;
};

/** \brief Finds the labels in the cell arrays of a mesh.
 *
 * \param name an array of one or two components, or two names of arrays of one with a comma between them. Empty: it is
 * looked for, in this order: BoundaryLabels; FaceLabels, of DREAM3D; the only array of two components of whole numbers;
 * the only two arrays of whole numbers whose names end in 1 and 2, 0 and 1, or A and B and are alike otherwise (label1,
 * label2); then, of one component, Label, Labels, label, labels, GroupLabels, RegionId.
 * \throws std::runtime_error where there are none, naming the arrays that there are, or a label is no whole number. */
SideLabels
FindSideLabels(vtkDataSet * mesh, const std::string & name, const std::string & path);
} // namespace tissue

#endif
