/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#ifndef TissueTessellationCore_Metric_h
#define TissueTessellationCore_Metric_h

#include "TissueTessellationCore/Common/Types.h"

namespace tissue
{
/** A symmetric positive definite 3x3 matrix: xx, xy, xz, yy, yz, zz. */
using Metric = std::array<double, 6>;

/** v' M v. */
inline double
QuadraticForm(const Metric & m, const Point & v)
{
  return v[0] * (m[0] * v[0] + 2.0 * (m[1] * v[1] + m[2] * v[2])) + v[1] * (m[3] * v[1] + 2.0 * m[4] * v[2]) +
         m[5] * v[2] * v[2];
}

/** Adds w v v' to a matrix. */
inline void
AddOuterProduct(double w, const Point & v, Metric & matrix)
{
  std::size_t entry = 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = i; j < 3; ++j)
    {
      matrix[entry++] += w * v[i] * v[j];
    }
  }
}

inline Metric
Inverse(const Metric & m)
{
  Metric       inverse = { { m[3] * m[5] - m[4] * m[4],
                             m[2] * m[4] - m[1] * m[5],
                             m[1] * m[4] - m[2] * m[3],
                             m[0] * m[5] - m[2] * m[2],
                             m[1] * m[2] - m[0] * m[4],
                             m[0] * m[3] - m[1] * m[1] } };
  const double determinant = m[0] * inverse[0] + m[1] * inverse[1] + m[2] * inverse[2];
  for (double & value : inverse)
  {
    value /= determinant;
  }
  return inverse;
}

/** Eigenvalues of a symmetric matrix, in no special order, and the unit eigenvector of each. */
struct SymmetricEigen
{
  std::array<double, 3> values;
  std::array<Point, 3>  vectors;
};

/** The matrix need not be definite. */
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
    AddOuterProduct(function(eigen.values[k]), eigen.vectors[k], result);
  }
  return result;
}
} // namespace tissue

#endif
