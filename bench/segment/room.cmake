# PCL is only a peer to compare with, where it is installed.
find_package(PCL QUIET COMPONENTS common search segmentation)
if(PCL_FOUND)
  target_compile_definitions(segment_bench PRIVATE SCANFUSE_HAVE_PCL)
  target_include_directories(segment_bench SYSTEM PRIVATE ${PCL_INCLUDE_DIRS})
  target_link_libraries(segment_bench PRIVATE ${PCL_LIBRARIES})
endif()
