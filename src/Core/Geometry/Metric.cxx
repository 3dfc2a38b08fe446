/*=========================================================================
 *
 *  Copyright The TissueTessellation contributors
 *  SPDX-License-Identifier: Apache-2.0
 *
 *=========================================================================*/
#include "TissueTessellationCore/Geometry/Metric.h"

#include <Eigen/Eigenvalues>

namespace tissue
{
SymmetricEigen
DecomposeSymmetric(const Metric & m)
{
  Eigen::Matrix3d matrix;
  matrix << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
  // By iteration: the closed form loses digits where eigenvalues are near each other.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(matrix);
  SymmetricEigen                                       eigen;
  for (int i = 0; i < 3; ++i)
  {
    const Eigen::Vector3d vector = solver.eigenvectors().col(i);
    eigen.values[i] = solver.eigenvalues()[i];
    eigen.vectors[i] = { { vector[0], vector[1], vector[2] } };
  }
  return eigen;
}
} // namespace tissue
