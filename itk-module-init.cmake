# CGAL gives the Delaunay tetrahedralization and the exact predicates.
find_package(CGAL 5.2 REQUIRED)
