# PCL is only a peer to compare with, where it is installed. Looked for by its files: PCL's own
# package configuration asks for VTK and MPI, which clustering does not need.
find_path(SCANFUSE_PCL_INCLUDE pcl/segmentation/extract_clusters.h
          PATH_SUFFIXES pcl-1.15 pcl-1.14 pcl-1.13 pcl-1.12)
set(pcl_libraries "")
foreach(part common kdtree search segmentation)
  find_library(SCANFUSE_PCL_${part} pcl_${part})
  list(APPEND pcl_libraries ${SCANFUSE_PCL_${part}})
endforeach()
if(SCANFUSE_PCL_INCLUDE AND SCANFUSE_PCL_segmentation AND SCANFUSE_PCL_search)
  target_compile_definitions(segment_bench PRIVATE SCANFUSE_HAVE_PCL)
  target_include_directories(segment_bench SYSTEM PRIVATE ${SCANFUSE_PCL_INCLUDE})
  target_link_libraries(segment_bench PRIVATE ${pcl_libraries})
endif()
