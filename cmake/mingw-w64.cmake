# A toolchain file: builds programs for Windows with the cross compiler MinGW-w64 of Debian (POSIX
# threads), and runs tests with Wine. CMAKE_FIND_ROOT_PATH names the folders with the libraries.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
set(CMAKE_C_COMPILER x86_64-w64-mingw32-gcc-posix)
set(CMAKE_CXX_COMPILER x86_64-w64-mingw32-g++-posix)
set(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_CXX_FLAGS_INIT -Wa,-mbig-obj) # the limit of sections is too low for many templates
set(CMAKE_EXE_LINKER_FLAGS_INIT -static) # Wine needs no search path of libraries
set(CMAKE_CROSSCOMPILING_EMULATOR wine)
# Debian's headers of Linux must not be found.
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
foreach(kind IN ITEMS LIBRARY INCLUDE PACKAGE)
  set(CMAKE_FIND_ROOT_PATH_MODE_${kind} ONLY)
endforeach()
