/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKBridge_h
#define TissueTessellationVTKBridge_h

// These headers make VTK data of the module's results: walls, cells with their statistics and what is projected on
// them, the adjacency complex, and the image's junctions.
#include "TissueTessellationVTK/CellSurfaces.h"
#include "TissueTessellationVTK/Cells.h"
#include "TissueTessellationVTK/Complex.h"
#include "TissueTessellationVTK/Junctions.h"
#include "TissueTessellationVTK/ProjectedData.h"
#include "TissueTessellationVTK/Walls.h"

#endif
