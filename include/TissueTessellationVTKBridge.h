/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationVTKBridge_h
#define TissueTessellationVTKBridge_h

// The results of the module as VTK data: walls, cells with their statistics, and the adjacency complex.
#include "TissueTessellationVTK/Cells.h"
#include "TissueTessellationVTK/Complex.h"
#include "TissueTessellationVTK/Junctions.h"
#include "TissueTessellationVTK/Walls.h"

#endif
