# Compiles the sources of PLUMB_APART each by itself, so that a change in one costs one of them.
function(plumb_apart)
  foreach(source IN LISTS PLUMB_APART)
    cmake_path(GET source PARENT_PATH room)
    string(MAKE_C_IDENTIFIER plumb_${room} room)
    set_source_files_properties(${CMAKE_SOURCE_DIR}/${source} TARGET_DIRECTORY ${room}
      PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endforeach()
endfunction()
cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL plumb_apart)
