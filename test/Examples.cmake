# The C++ examples, built and run on an image of nuclei. Python's is run by PythonWrapping.cmake.
add_subdirectory(${PROJECT_SOURCE_DIR}/examples ${CMAKE_CURRENT_BINARY_DIR}/examples)
set(folder ${CMAKE_CURRENT_BINARY_DIR}/examples)
add_test(NAME ExampleNuclei COMMAND SyntheticTissue --cells 60 --size 64 64 48 --signalToNoise 10 --quiet
  ${folder}/tissue.mha --nuclei ${folder}/nuclei.mha)
set_tests_properties(ExampleNuclei PROPERTIES FIXTURES_SETUP ExampleNuclei)
add_test(NAME ExampleNucleiToLayers COMMAND NucleiToLayers ${folder}/nuclei.mha)
set_tests_properties(ExampleNucleiToLayers PROPERTIES FIXTURES_REQUIRED ExampleNuclei
  PASS_REGULAR_EXPRESSION "layer,cells,mean volume\n1,[3-6][0-9],[0-9.]+\n2,[0-9]+,")
add_test(NAME ExampleWatershedToWalls COMMAND WatershedToWalls ${folder}/nuclei.mha ${folder}/walls.vtp)
set_tests_properties(ExampleWatershedToWalls PROPERTIES FIXTURES_REQUIRED ExampleNuclei
  PASS_REGULAR_EXPRESSION "(5[5-9]|6[0-5]) cells, [0-9]+ triangles")
