# The modules of 3D Slicer are installed and describe themselves; the extension is configured with a stand-in for Slicer,
# which gives what Slicer's package does, and ITK's remote module with one for ITK's function.
# Run by ctest: cmake -DROOT=<source> -DBUILD=<built> -DFOLDER=<to work in> -P SlicerExtension.cmake
cmake_minimum_required(VERSION 3.19)

function(require condition)
  if(NOT (${ARGN}))
    message(SEND_ERROR "${condition}")
  endif()
endfunction()

file(REMOVE_RECURSE ${FOLDER})
execute_process(COMMAND ${CMAKE_COMMAND} --install ${BUILD} --component SlicerModules --prefix ${FOLDER}/modules
  OUTPUT_QUIET)
file(GLOB_RECURSE modules RELATIVE ${FOLDER}/modules ${FOLDER}/modules/*)
set(expected cli-modules/NucleiDetection cli-modules/NucleiTessellation cli-modules/TissueTessellation)
require("installed as modules are: ${modules}" modules STREQUAL expected)
foreach(module IN LISTS modules)
  execute_process(COMMAND ${FOLDER}/modules/${module} --xml OUTPUT_VARIABLE output ERROR_VARIABLE error)
  require("${module} does not describe itself: ${error}" output MATCHES "^<[?]xml .*</executable>")
endforeach()

file(WRITE ${FOLDER}/SlicerConfig.cmake [[
set(Slicer_USE_FILE ${CMAKE_CURRENT_LIST_DIR}/UseSlicer.cmake)
set(Slicer_EXTENSION_GENERATE_CONFIG ${CMAKE_CURRENT_LIST_DIR}/Generate.cmake)
set(Slicer_EXTENSION_CPACK ${CMAKE_CURRENT_LIST_DIR}/Generate.cmake)
set(Slicer_CLIMODULES_BIN_DIR lib/Slicer-5.9/cli-modules)
set(Slicer_INSTALL_CLIMODULES_BIN_DIR Slicer-5.9/TissueTessellation/lib/Slicer-5.9/cli-modules)
]])
file(WRITE ${FOLDER}/UseSlicer.cmake "")
file(WRITE ${FOLDER}/Generate.cmake [[
foreach(name EXTENSION_NAME EXTENSION_CONTRIBUTORS EXTENSION_DESCRIPTION EXTENSION_DEPENDS)
  if("${${name}}" STREQUAL "")
    message(SEND_ERROR "${name} is not set")
  endif()
endforeach()
]])
execute_process(COMMAND ${CMAKE_COMMAND} -S ${ROOT}/slicer -B ${FOLDER}/build -DSlicer_DIR=${FOLDER}
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
require("the extension cannot be configured: ${output}" result EQUAL 0)
file(READ ${FOLDER}/build/cmake_install.cmake rules)
foreach(module NucleiDetection NucleiTessellation TissueTessellation)
  string(FIND "${rules}" "/cli-modules/${module}\"" place)
  require("${module} is not installed where Slicer looks for modules" NOT place EQUAL -1)
endforeach()

file(READ ${ROOT}/slicer/TissueTessellation.json entry)
foreach(member $schema category scm_url)
  string(JSON value ERROR_VARIABLE missing GET "${entry}" ${member})
  require("the catalogue's entry has no ${member}" missing STREQUAL NOTFOUND)
endforeach()

function(itk_fetch_module name words)
  cmake_parse_arguments(module "" "MODULE_COMPLIANCE_LEVEL;GIT_REPOSITORY;GIT_TAG" "" ${ARGN})
  require("the remote module is ${name} of ${ARGN}" name STREQUAL TissueTessellation AND
    module_GIT_REPOSITORY STREQUAL "${ROOT}" AND module_GIT_TAG STREQUAL main AND module_MODULE_COMPLIANCE_LEVEL)
endfunction()
set(TissueTessellation_GIT_REPOSITORY ${ROOT} CACHE STRING "")
include(${ROOT}/TissueTessellation.remote.cmake)
