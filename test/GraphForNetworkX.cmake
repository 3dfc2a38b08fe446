# The graph of neighbours and the tables of cells and walls, as a user of Python reads them.
execute_process(COMMAND /usr/bin/python3 -c "import networkx" RESULT_VARIABLE failed ERROR_QUIET)
if(failed)
  add_skipped_test(GraphForNetworkX "python3-networkx")
  return()
endif()

set(folder "${CMAKE_CURRENT_BINARY_DIR}/GraphForNetworkX")
file(MAKE_DIRECTORY "${folder}")
add_test(NAME GraphForNetworkXTissue COMMAND SyntheticTissue "${folder}/tissue.mha" --cells 60)
add_test(NAME GraphForNetworkXMesh COMMAND TissueTessellationApp "${folder}/tissue.mha" "${folder}/walls.vtp"
  --statistics "${folder}/cells.csv" --walls "${folder}/walls.csv" --graph "${folder}/graph.graphml")
add_test(NAME GraphForNetworkX
  COMMAND /usr/bin/python3 -B "${CMAKE_CURRENT_SOURCE_DIR}/Programs/graph_for_networkx.py" "${folder}")
set_tests_properties(GraphForNetworkXTissue PROPERTIES FIXTURES_SETUP GraphForNetworkXTissue)
set_tests_properties(GraphForNetworkXMesh PROPERTIES
  FIXTURES_REQUIRED GraphForNetworkXTissue FIXTURES_SETUP GraphForNetworkXMesh)
set_tests_properties(GraphForNetworkX PROPERTIES FIXTURES_REQUIRED GraphForNetworkXMesh)
