# CBC is the oracle of the packing solvers, where it is installed.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(CBC QUIET IMPORTED_TARGET cbc)
endif()
find_path(CBC_ORACLE_INCLUDE coin/Cbc_C_Interface.h)
if(CBC_FOUND AND CBC_ORACLE_INCLUDE)
  target_compile_definitions(associate_test PRIVATE SCANFUSE_HAVE_CBC)
  target_include_directories(associate_test SYSTEM PRIVATE ${CBC_ORACLE_INCLUDE}
                             ${CBC_ORACLE_INCLUDE}/coin)
  target_link_libraries(associate_test PRIVATE PkgConfig::CBC)
else()
  message(STATUS "CBC is not installed: tests against it are skipped")
endif()
