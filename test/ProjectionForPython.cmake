# What is projected on cells and walls, as a user of Python reads it, beside what NumPy makes of the same images.
execute_process(COMMAND /usr/bin/python3 -c "import networkx, numpy, vtk" RESULT_VARIABLE failed ERROR_QUIET)
if(failed)
  add_skipped_test(ProjectionForPython "python3-networkx, python3-numpy or python3-vtk9")
  return()
endif()

set(folder "${CMAKE_CURRENT_BINARY_DIR}/ProjectionForPython")
file(MAKE_DIRECTORY "${folder}")
add_test(NAME ProjectionForPythonTissue COMMAND SyntheticTissue "${folder}/tissue.mha" --cells 40 --size 60 56 50
  --spacing 0.5 0.5 0.8)
add_test(NAME ProjectionForPython COMMAND /usr/bin/python3 -B
  "${CMAKE_CURRENT_SOURCE_DIR}/Programs/projection_for_python.py" $<TARGET_FILE:TissueTessellationApp> "${folder}")
set_tests_properties(ProjectionForPythonTissue PROPERTIES FIXTURES_SETUP ProjectionForPythonTissue)
set_tests_properties(ProjectionForPython PROPERTIES FIXTURES_REQUIRED ProjectionForPythonTissue)
