# Warnings, sanitizers, and the tools that make builds quick.
add_library(scanfuse_options INTERFACE)
target_compile_options(scanfuse_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow
                       -Wnon-virtual-dtor -Woverloaded-virtual -ffp-contract=off)
if(SCANFUSE_WERROR)
  target_compile_options(scanfuse_options INTERFACE -Werror)
endif()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12 reports these inside Eigen's and the standard library's inlined code at -O2.
  target_compile_options(scanfuse_options INTERFACE -Wno-array-bounds -Wno-stringop-overflow
                         -Wno-maybe-uninitialized -Wno-restrict -Wno-stringop-overread)
else()
  # std::stable_sort of libstdc++ 12 uses what C++17 deprecated.
  target_compile_options(scanfuse_options INTERFACE -Wno-deprecated-declarations)
endif()

set(SCANFUSE_SANITIZE "" CACHE STRING "Sanitizers for everything, for example address,undefined")
if(SCANFUSE_SANITIZE)
  add_compile_options(-fsanitize=${SCANFUSE_SANITIZE} -fno-omit-frame-pointer
                      -fno-sanitize-recover=all)
  add_link_options(-fsanitize=${SCANFUSE_SANITIZE})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    # Checks of undefined behaviour inside Eigen and the standard library double the build's time.
    add_compile_options(-fsanitize-ignorelist=${CMAKE_CURRENT_LIST_DIR}/sanitize_ignore.txt)
  endif()
endif()

if(SCANFUSE_FAST_TOOLS)
  find_program(SCANFUSE_CCACHE ccache)
  if(SCANFUSE_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${SCANFUSE_CCACHE})
  endif()
  find_program(SCANFUSE_MOLD mold)
  if(SCANFUSE_MOLD)
    add_link_options(-fuse-ld=mold)
  endif()
endif()
