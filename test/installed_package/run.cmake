# Installs `build_dir` below `work_dir`, then configures, builds and runs the project of this folder
# against what was installed.
file(REMOVE_RECURSE "${work_dir}")
set(prefix "${work_dir}/prefix")
set(program "${prefix}/${program_in_prefix}")
set(scenes "${prefix}/${scenes_in_prefix}")
set(components)
if(with_compiled)
  list(APPEND components Compiled)
endif()
if(with_tetgen)
  list(APPEND components Tetgen)
endif()
if(with_petsc)
  list(APPEND components Petsc)
endif()

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

run("${CMAKE_COMMAND}" --install "${build_dir}" --config "${config}" --prefix "${prefix}")
# The program finds the scenes that were installed with it, not those of the source tree.
file(COPY_FILE "${scenes}/droplet.json" "${scenes}/copy_of_droplet.json")
run("${program}" fluid --print copy_of_droplet)
run("${CMAKE_COMMAND}" -S "${CMAKE_CURRENT_LIST_DIR}" -B "${work_dir}/build" -G "${generator}"
  "-DCMAKE_CXX_COMPILER=${cxx_compiler}"
  "-DCMAKE_BUILD_TYPE=${config}"
  "-DCMAKE_PREFIX_PATH=${prefix}"
  "-DCOMPONENTS=${components}")
run("${CMAKE_COMMAND}" --build "${work_dir}/build" --config "${config}")
run("${CMAKE_CTEST_COMMAND}" --test-dir "${work_dir}/build" -C "${config}" --output-on-failure)
