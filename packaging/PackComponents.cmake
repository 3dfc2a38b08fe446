# Read by cpack for each of its generators: the libraries of others are in the archive alone.
set(CPACK_COMPONENTS_ALL Runtime Development)
if(CPACK_GENERATOR STREQUAL "TGZ")
  list(APPEND CPACK_COMPONENTS_ALL Libraries)
endif()
