# CGAL gives the Delaunay tetrahedralization and the exact predicates.
find_package(CGAL 5.2 REQUIRED)
# Eigen solves the systems of the fit.
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
