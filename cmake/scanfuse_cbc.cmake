# Links CBC (an integer programming solver) to a test or benchmark and defines SCANFUSE_HAVE_CBC;
# says so and does nothing where it is not installed. The product never needs it.
function(scanfuse_link_cbc target)
  find_package(PkgConfig QUIET)
  if(PkgConfig_FOUND)
    pkg_check_modules(CBC QUIET IMPORTED_TARGET GLOBAL cbc)
  endif()
  find_path(CBC_PEER_INCLUDE coin/Cbc_C_Interface.h)
  if(NOT TARGET PkgConfig::CBC OR NOT CBC_PEER_INCLUDE)
    message(STATUS "${target}: CBC is not installed, what needs it is left out")
    return()
  endif()
  target_compile_definitions(${target} PRIVATE SCANFUSE_HAVE_CBC)
  target_include_directories(${target} SYSTEM PRIVATE ${CBC_PEER_INCLUDE}
                             ${CBC_PEER_INCLUDE}/coin)
  target_link_libraries(${target} PRIVATE PkgConfig::CBC)
endfunction()
