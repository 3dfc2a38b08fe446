# Installs the static libraries of BUILD, and shared ones of the same core, into FOLDER, and has projects find, link and run
# them as users' projects do.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(result)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "${command}\n${output}")
  endif()
endfunction()

# consume(<prefix> <kind> [<argument of the program>...]) builds the project against a prefix, and runs it.
function(consume prefix kind)
  set(build ${prefix}/consumer-${kind})
  run(${CMAKE_COMMAND} -S ${SOURCE}/test/Package -B ${build} -G Ninja -DCMAKE_BUILD_TYPE=Debug -DKIND=${kind}
    -DCMAKE_PREFIX_PATH=${prefix} -DSAMPLE=${SAMPLE} ${LAUNCHER})
  run(${CMAKE_COMMAND} --build ${build})
  run(${build}/consumer ${ARGN})
endfunction()

file(REMOVE_RECURSE ${FOLDER})
set(static ${FOLDER}/static)
set(shared ${FOLDER}/shared)
run(${CMAKE_COMMAND} --install ${BUILD} --prefix ${static})
foreach(file bin/TissueTessellation share/bash-completion/completions/TissueTessellation
    share/doc/tissuetessellation/LICENSE share/doc/tissuetessellation/README.md)
  if(NOT EXISTS ${static}/${file})
    message(FATAL_ERROR "${file} is not installed.")
  endif()
endforeach()
run(${CMAKE_COMMAND} -E env --unset=LD_LIBRARY_PATH ${static}/bin/TissueTessellation --version)
consume(${static} Core)
consume(${static} ItkLast ${TISSUE} ${FOLDER}/static.vtp)

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${FOLDER}/build -G Ninja -DCMAKE_BUILD_TYPE=Release -DBUILD_SHARED_LIBS=ON
  -DBUILD_TESTING=OFF -DTissueTessellation_BUILD_APPS=OFF -DTissueTessellation_CORE_OBJECTS=${CORE_OBJECTS} ${LAUNCHER})
run(${CMAKE_COMMAND} --build ${FOLDER}/build)
run(${CMAKE_COMMAND} --install ${FOLDER}/build --prefix ${shared})
consume(${shared} Core)
consume(${shared} ItkFirst ${TISSUE} ${FOLDER}/shared.vtp)
file(SHA256 ${FOLDER}/static.vtp hashOfStatic)
file(SHA256 ${FOLDER}/shared.vtp hashOfShared)
if(NOT hashOfStatic STREQUAL hashOfShared)
  message(FATAL_ERROR "The shared libraries give another mesh than the static ones.")
endif()
