# PCL is only a peer to compare with, where it is installed. Its own package configuration asks for
# VTK, OpenNI and more, and stops the build where they are missing: the three parts are looked up.
find_path(PCL_PEER_INCLUDE pcl/segmentation/extract_clusters.h PATH_SUFFIXES pcl-1.13 pcl-1.14
          pcl-1.15 pcl-1.12)
set(pcl_peer ${PCL_PEER_INCLUDE})
foreach(part segmentation search kdtree common)
  find_library(PCL_PEER_${part} pcl_${part})
  list(APPEND pcl_peer ${PCL_PEER_${part}})
endforeach()
list(LENGTH pcl_peer found)
if(found EQUAL 5 AND NOT "${pcl_peer}" MATCHES "NOTFOUND")
  target_compile_definitions(segment_bench PRIVATE SCANFUSE_HAVE_PCL)
  target_include_directories(segment_bench SYSTEM PRIVATE ${PCL_PEER_INCLUDE})
  target_link_libraries(segment_bench PRIVATE ${PCL_PEER_segmentation} ${PCL_PEER_search}
                        ${PCL_PEER_kdtree} ${PCL_PEER_common})
endif()
