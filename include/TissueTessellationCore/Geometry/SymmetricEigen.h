/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_SymmetricEigen_h
#define TissueTessellationCore_SymmetricEigen_h

#include "TissueTessellationCore/Geometry/Metric.h"

namespace tissue
{
/** Eigenvalues of a symmetric matrix, in no special order, and the unit eigenvector of each. */
struct SymmetricEigen
{
  std::array<double, 3> values;
  std::array<Point, 3>  vectors;
};

/** By Jacobi's rotations; the matrix need not be definite. */
SymmetricEigen
DecomposeSymmetric(const Metric & matrix);

/** The matrix of the same eigenvectors with function(value) for each eigenvalue: its logarithm, for one. */
template <typename TFunction>
Metric
MapEigenvalues(const Metric & matrix, const TFunction & function)
{
  const SymmetricEigen eigen = DecomposeSymmetric(matrix);
  Metric               result = { { 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 } };
  for (int k = 0; k < 3; ++k)
  {
    const double  value = function(eigen.values[k]);
    const Point & v = eigen.vectors[k];
    int           entry = 0;
    for (int i = 0; i < 3; ++i)
    {
      for (int j = i; j < 3; ++j)
      {
        result[entry++] += value * v[i] * v[j];
      }
    }
  }
  return result;
}
} // namespace tissue

#endif
