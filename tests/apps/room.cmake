# They run the tool on whole scenarios several times, or on a session of rendered images.
set(slow "RealRecordings.BagsOfPeople*:RealRecordings.CarmenLogs*:RealRoad.*:LearnClasses.WhatItWrites*:SameBytes.*:Turntable.FeaturesGive*:Turntable.RenderedImages*:Turntable.SameSeed*")
# A stand-in for a node of ROS 2, where another vendor's DDS is installed.
find_path(FASTDDS_INCLUDE fastdds/dds/domain/DomainParticipant.hpp)
find_library(FASTDDS_LIBRARY fastrtps)
find_library(FASTCDR_LIBRARY fastcdr)
mark_as_advanced(FASTDDS_INCLUDE FASTDDS_LIBRARY FASTCDR_LIBRARY)
if(FASTDDS_INCLUDE AND FASTDDS_LIBRARY AND FASTCDR_LIBRARY)
  add_executable(ros2_peer ${PROJECT_SOURCE_DIR}/tests/ros2_peer/ros2_peer.cpp)
  target_include_directories(ros2_peer SYSTEM PRIVATE ${FASTDDS_INCLUDE})
  target_compile_options(ros2_peer PRIVATE $<$<CONFIG:Release>:-O1>)
  target_link_libraries(ros2_peer PRIVATE scanfuse_options ${FASTDDS_LIBRARY} ${FASTCDR_LIBRARY})
  if(SCANFUSE_SANITIZE)  # Fast DDS frees what it made with another size; it is not what is tested
    target_compile_options(ros2_peer PRIVATE -fno-sanitize=all)
    target_link_options(ros2_peer PRIVATE -fno-sanitize=all)
  endif()
  add_dependencies(apps_test ros2_peer)
  target_compile_definitions(apps_test PRIVATE SCANFUSE_ROS2_PEER="$<TARGET_FILE:ros2_peer>")
endif()
