# Compiles the sources of PLUMB_APART each by itself, so that a change in one costs one of them.
function(plumb_apart)
  list(TRANSFORM PLUMB_APART PREPEND ${CMAKE_SOURCE_DIR}/ OUTPUT_VARIABLE sources)
  set_source_files_properties(${sources} TARGET_DIRECTORY plumb_loop plumb_render plumb_report
    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()
cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL plumb_apart)
