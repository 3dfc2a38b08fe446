# ITK's own Python wrapping of this module, which needs an ITK build tree: an inner build in that mode, from the base that
# wrapping/debian/make-base makes, then the tests of wrapping/test on what it built.
find_file(TissueTessellation_PYTHON_BASE NAMES itk-python-base.tar.xz itk-5.2.1-python-base.tar.xz
  PATHS "${PROJECT_SOURCE_DIR}/.itk-python" "${PROJECT_SOURCE_DIR}/../shared/wrapping" NO_DEFAULT_PATH
  DOC "Packed ITK build tree with Python wrapping, made by wrapping/debian/make-base; without it its test is skipped")

set(missing "")
if(NOT EXISTS "${TissueTessellation_PYTHON_BASE}")
  list(APPEND missing "the base of wrapping/debian/make-base")
elseif(NOT ITK_VERSION VERSION_EQUAL 5.2.1)
  list(APPEND missing "ITK 5.2.1 of Debian")
endif()
require_tools(missing castxml swig)
if(missing)
  add_skipped_test(PythonWrapping ${missing})
  return()
endif()

# The build writes into the base: it has its own copy.
set(folder "${CMAKE_CURRENT_BINARY_DIR}/PythonWrapping")
file(MAKE_DIRECTORY "${folder}")
add_test(NAME PythonWrappingBase COMMAND ${CMAKE_COMMAND} -E tar xf "${TissueTessellation_PYTHON_BASE}"
  WORKING_DIRECTORY "${folder}")
set(base "${folder}/itk-python-base")
# The parsed headers are made anew: what ITK's rules know of their dependencies ends at the wrapped header itself.
add_test(NAME PythonWrappingParsedAnew COMMAND ${CMAKE_COMMAND} -E rm -rf "${base}/Wrapping")
set_tests_properties(PythonWrappingParsedAnew PROPERTIES FIXTURES_SETUP PythonWrappingBase)
set_tests_properties(PythonWrappingBase PROPERTIES FIXTURES_SETUP PythonWrappingBase DEPENDS PythonWrappingParsedAnew)
add_test(NAME PythonWrapping COMMAND ${CMAKE_CTEST_COMMAND}
  --build-and-test "${PROJECT_SOURCE_DIR}" "${folder}/build" --build-generator Ninja --build-noclean
  --build-options "-DITK_DIR=${base}" -DCMAKE_BUILD_TYPE=Release "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG"
    "-DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}" -DBUILD_TESTING=OFF
    "-DTissueTessellation_CORE_OBJECTS=${PROJECT_BINARY_DIR}/src/Core/CMakeFiles/TissueTessellationCore.dir"
  --test-command ${CMAKE_COMMAND} -E env "PYTHONPATH=${base}/Wrapping/Generators/Python" /usr/bin/python3
    -B -m unittest discover -s "${PROJECT_SOURCE_DIR}/wrapping/test" -p "*Test.py")
set_tests_properties(PythonWrapping PROPERTIES FIXTURES_REQUIRED PythonWrappingBase PROCESSORS 2)
