# require_tools(<variable> <tool>...) appends those programs to a list that this machine has not.
function(require_tools variable)
  foreach(tool IN LISTS ARGN)
    string(TOUPPER ${tool} name)
    find_program(${name}_EXECUTABLE ${tool})
    mark_as_advanced(${name}_EXECUTABLE)
    if(NOT ${name}_EXECUTABLE)
      list(APPEND ${variable} ${tool})
    endif()
  endforeach()
  set(${variable} "${${variable}}" PARENT_SCOPE)
endfunction()

# add_skipped_test(<name> <missing>...) adds a test that says what it needs.
function(add_skipped_test name)
  list(JOIN ARGN ", " missing)
  add_test(NAME ${name} COMMAND ${CMAKE_COMMAND} -E echo "Skipped: needs ${missing}")
  set_tests_properties(${name} PROPERTIES SKIP_REGULAR_EXPRESSION "Skipped: needs")
endfunction()
