# `cmake --install` puts headers, libraries, the tool and a package configuration in place.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
get_property(rooms GLOBAL PROPERTY SCANFUSE_ROOMS)
install(TARGETS ${rooms} scanfuse_all EXPORT scanfuse_targets
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS scanfuse_cli RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY scanfuse DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.hpp")
install(EXPORT scanfuse_targets NAMESPACE scanfuse::
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scanfuse)
configure_package_config_file(cmake/scanfuse-config.cmake.in scanfuse-config.cmake
                              INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scanfuse)
write_basic_package_version_file(scanfuse-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/scanfuse-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/scanfuse-config-version.cmake
        DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/scanfuse)
