# What cmake --install and cpack take: libraries, headers, programs with their manuals and completions, and a package for
# find_package(TissueTessellation).
set(packageFolder ${CMAKE_INSTALL_LIBDIR}/cmake/TissueTessellation)
set_target_properties(TissueTessellation TissueTessellationCore PROPERTIES
  VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})

# The bridge is headers only.
add_library(TissueTessellationVTK INTERFACE)
target_link_libraries(TissueTessellationVTK INTERFACE TissueTessellation VTK::CommonCore VTK::CommonDataModel)

install(DIRECTORY include/ ${PROJECT_BINARY_DIR}/include/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT Development)
foreach(library TissueTessellationCore TissueTessellation TissueTessellationVTK)
  install(TARGETS ${library} EXPORT ${library}Targets
    LIBRARY COMPONENT Runtime NAMELINK_COMPONENT Development ARCHIVE COMPONENT Development)
  install(EXPORT ${library}Targets NAMESPACE TissueTessellation:: DESTINATION ${packageFolder} COMPONENT Development)
endforeach()

set(CGAL_VERSION_NEEDED 5.2)
set(TissueTessellation_ITK_COMPONENTS
  "ITKCommon ITKHDF5 ITKIOImageBase ITKImageIntensity ITKLabelMap ITKSmoothing ITKStatistics")
configure_file(packaging/TissueTessellationConfig.cmake.in TissueTessellationConfig.cmake @ONLY)
include(CMakePackageConfigHelpers)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/TissueTessellationConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/TissueTessellationConfig.cmake
  ${PROJECT_BINARY_DIR}/TissueTessellationConfigVersion.cmake DESTINATION ${packageFolder} COMPONENT Development)
install(FILES README.md LICENSE CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT Runtime)

# Manuals and completions are made of what the programs say of their options.
if(TissueTessellation_BUILD_APPS)
  find_program(TissueTessellation_HELP2MAN help2man)
  mark_as_advanced(TissueTessellation_HELP2MAN)
  set(texts)
  foreach(program ${TissueTessellation_PROGRAMS})
    get_target_property(name ${program} OUTPUT_NAME)
    if(NOT name)
      set(name ${program})
    endif()
    set(options -DPROGRAM=$<TARGET_FILE:${program}> -DNAME=${name})
    set(completion ${PROJECT_BINARY_DIR}/completions/${name})
    add_custom_command(OUTPUT ${completion} VERBATIM DEPENDS ${program} packaging/BashCompletion.cmake
      COMMAND ${CMAKE_COMMAND} ${options} -DOUTPUT=${completion} -P ${PROJECT_SOURCE_DIR}/packaging/BashCompletion.cmake)
    list(APPEND texts ${completion})
    if(TissueTessellation_HELP2MAN)
      set(manual ${PROJECT_BINARY_DIR}/man/${name}.1)
      add_custom_command(OUTPUT ${manual} VERBATIM DEPENDS ${program} packaging/Manual.cmake
        COMMAND ${CMAKE_COMMAND} ${options} -DOUTPUT=${manual} -DHELP2MAN=${TissueTessellation_HELP2MAN}
          -P ${PROJECT_SOURCE_DIR}/packaging/Manual.cmake)
      list(APPEND texts ${manual})
    endif()
  endforeach()
  add_custom_target(TissueTessellationManuals ALL DEPENDS ${texts})
  install(DIRECTORY ${PROJECT_BINARY_DIR}/completions/ COMPONENT Runtime
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
  if(TissueTessellation_HELP2MAN)
    install(DIRECTORY ${PROJECT_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT Runtime)
  endif()
endif()
