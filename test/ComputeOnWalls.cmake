# A tissue's walls meshed by Gmsh and TetGen and computed on by CalculiX, as users would: benchmark/compute_on_walls.py.
set(missing "")
require_tools(missing gmsh tetgen ccx)
execute_process(COMMAND /usr/bin/python3 -c "import meshio, vtkmodules.vtkIOXML" RESULT_VARIABLE failed ERROR_QUIET)
if(failed)
  list(APPEND missing "python3-meshio and python3-vtk9")
endif()
if(missing)
  add_skipped_test(ComputeOnWalls ${missing})
  return()
endif()

set(folder "${CMAKE_CURRENT_BINARY_DIR}/ComputeOnWalls")
file(MAKE_DIRECTORY "${folder}")
add_test(NAME ComputeOnWallsTissue COMMAND SyntheticTissue "${folder}/tissue.mha" --cells 30)
add_test(NAME ComputeOnWallsMesh COMMAND TissueTessellationApp "${folder}/tissue.mha" "${folder}/walls.vtp"
  --simulation "${folder}/tissue.geo" --simulation "${folder}/tissue.smesh" --statistics "${folder}/cells.csv"
  --cells "${folder}/cells.vtu" --complex "${folder}/complex.vtu")
add_test(NAME ComputeOnWalls
  COMMAND /usr/bin/python3 -B "${PROJECT_SOURCE_DIR}/benchmark/compute_on_walls.py" "${folder}")
set_tests_properties(ComputeOnWallsTissue PROPERTIES FIXTURES_SETUP ComputeOnWallsTissue)
set_tests_properties(ComputeOnWallsMesh PROPERTIES
  FIXTURES_REQUIRED ComputeOnWallsTissue FIXTURES_SETUP ComputeOnWallsMesh)
set_tests_properties(ComputeOnWalls PROPERTIES FIXTURES_REQUIRED ComputeOnWallsMesh)
# All grids are read by others, each value at its own cell.
add_test(NAME GridsForMeshio COMMAND /usr/bin/python3 -B "${CMAKE_CURRENT_SOURCE_DIR}/Programs/grids_for_meshio.py" "${folder}")
set_tests_properties(GridsForMeshio PROPERTIES FIXTURES_REQUIRED ComputeOnWallsMesh)
