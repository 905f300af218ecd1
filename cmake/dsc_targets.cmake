# Functions for the targets of the examples, benchmarks and tests.

# Links `target` to the package, and to the TetGen adapter if it is built.
function(dsc_link_package target)
  target_link_libraries(${target} PRIVATE deformable_simplicial_complex)
  if(TARGET deformable_simplicial_complex_tetgen)
    target_link_libraries(${target} PRIVATE deformable_simplicial_complex_tetgen)
  endif()
endfunction()

# Lets `target` fill space around surfaces with the header input/tetrahedralizer.h: with TetGen if its
# adapter is built, otherwise with CGAL.
function(dsc_link_tetrahedralizer target)
  if(TARGET deformable_simplicial_complex_tetgen)
    target_link_libraries(${target} PUBLIC deformable_simplicial_complex_tetgen)
    target_compile_definitions(${target} PUBLIC DSC_WITH_TETGEN DSC_TETRAHEDRALIZER="TetGen")
  else()
    target_compile_definitions(${target} PUBLIC DSC_TETRAHEDRALIZER="CGAL")
  endif()
endfunction()

# Lets `target` use the compiled instantiations and the precompiled headers.
function(dsc_share_compilation target)
  target_link_libraries(${target} PRIVATE deformable_simplicial_complex_compiled)
  if(NOT TARGET dsc_common_headers)
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/common_headers.cpp" CONTENT "")
    add_library(dsc_common_headers OBJECT "${PROJECT_BINARY_DIR}/common_headers.cpp")
    dsc_link_package(dsc_common_headers)
    target_link_libraries(dsc_common_headers PRIVATE deformable_simplicial_complex_compiled)
    target_precompile_headers(dsc_common_headers PRIVATE "${PROJECT_SOURCE_DIR}/cmake/common_headers.h")
  endif()
  target_precompile_headers(${target} REUSE_FROM dsc_common_headers)
endfunction()

# Precompiles the headers of other libraries for a library, if compilation is shared. The options are those of
# position-independent code. A target with other options has its own precompiled headers.
function(dsc_precompile_external_headers target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "OTHER_OPTIONS" "" "")
  set(header "${PROJECT_SOURCE_DIR}/cmake/external_headers.h")
  if(NOT DSC_SHARE_COMPILATION)
    return()
  endif()
  if(arg_OTHER_OPTIONS)
    target_precompile_headers(${target} PRIVATE "${header}")
    return()
  endif()
  if(NOT TARGET dsc_external_headers)
    file(CONFIGURE OUTPUT "${PROJECT_BINARY_DIR}/external_headers.cpp" CONTENT "")
    add_library(dsc_external_headers OBJECT "${PROJECT_BINARY_DIR}/external_headers.cpp")
    set_target_properties(dsc_external_headers PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(dsc_external_headers PRIVATE deformable_simplicial_complex)
    target_precompile_headers(dsc_external_headers PRIVATE "${header}")
  endif()
  target_precompile_headers(${target} REUSE_FROM dsc_external_headers)
endfunction()

# Sets `result` to the .cpp files of the current folder and of its subfolders, except
# `installed_package`. Without the TetGen adapter, leaves out the files that use it.
function(dsc_glob_sources result)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE "${CMAKE_CURRENT_SOURCE_DIR}" *.cpp)
  list(FILTER files EXCLUDE REGEX "^installed_package/")
  set(sources)
  foreach(file IN LISTS files)
    file(STRINGS "${file}" uses_tetgen REGEX "Tetgen_tetrahedralizer_3" LIMIT_COUNT 1)
    if(TARGET deformable_simplicial_complex_tetgen OR NOT uses_tetgen)
      list(APPEND sources "${file}")
    endif()
  endforeach()
  set(${result} "${sources}" PARENT_SCOPE)
endfunction()

# Adds a program for `file`. The target is `prefix`_NAME and the executable is NAME, where NAME is the
# name of the file without extension. Sets `result` to the name of the target.
function(dsc_add_single_source_program result prefix file)
  get_filename_component(name "${file}" NAME_WE)
  add_executable(${prefix}_${name} "${file}")
  set_target_properties(${prefix}_${name} PROPERTIES OUTPUT_NAME "${name}")
  dsc_link_package(${prefix}_${name})
  if(DSC_SHARE_COMPILATION)
    dsc_share_compilation(${prefix}_${name})
    target_link_libraries(${prefix}_${name} PRIVATE incompressible_fluids_compiled)
  endif()
  set(${result} ${prefix}_${name} PARENT_SCOPE)
endfunction()
