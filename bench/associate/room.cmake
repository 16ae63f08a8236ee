# The scenes are those of the tests; CBC is only a peer to compare with, where it is installed.
target_include_directories(associate_bench PRIVATE ${PROJECT_SOURCE_DIR}/tests)
include(${PROJECT_SOURCE_DIR}/cmake/scanfuse_cbc.cmake)
scanfuse_link_cbc(associate_bench)
