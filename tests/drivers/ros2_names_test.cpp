#include <gtest/gtest.h>

#include <cstdlib>

#include "scanfuse/drivers/ros2/ros2_bus.hpp"

namespace scanfuse::drivers {
namespace {

TEST(Ros2Names, TypesAreNamedOnTheWireAsRos2DoesIt) {
  EXPECT_EQ(dds_type_name("sensor_msgs/msg/LaserScan"), "sensor_msgs::msg::dds_::LaserScan_");
  EXPECT_EQ(dds_type_name("tf2_msgs/msg/TFMessage"), "tf2_msgs::msg::dds_::TFMessage_");
  for (const char* type : {"sensor_msgs/msg/PointCloud2", "visualization_msgs/msg/MarkerArray"}) {
    EXPECT_EQ(ros2_type_name(dds_type_name(type)), type);
  }
  EXPECT_EQ(ros2_type_name("HelloWorldData::Msg"), "HelloWorldData::Msg") << "not of ROS 2";
}

TEST(Ros2Names, TopicsAreTakenWithAndWithoutTheSlash) {
  for (const char* good : {"/scan", "scan", "/front/scan", "/a_b/c9", "/_hidden"}) {
    const auto name = ros2_topic_name(good);
    ASSERT_TRUE(name) << good;
    EXPECT_EQ(name->front(), '/');
  }
  for (const char* bad :
       {"", "/", "/scan/", "//scan", "/9scan", "/a b", "/a__b", "/a-b", "/sc\xC3\xA4n"}) {
    EXPECT_FALSE(ros2_topic_name(bad)) << bad;
  }
}

TEST(Ros2Names, TheDomainComesFromTheEnvironment) {
  ::unsetenv("ROS_DOMAIN_ID");
  EXPECT_EQ(ros2_domain().value(), 0);
  for (const auto& [text, domain] : {std::pair{"42", 42}, std::pair{"232", 232}}) {
    ::setenv("ROS_DOMAIN_ID", text, 1);
    EXPECT_EQ(ros2_domain().value(), domain);
  }
  for (const char* bad : {"-1", "233", "x", "7 ", "99999999999"}) {
    ::setenv("ROS_DOMAIN_ID", bad, 1);
    const auto domain = ros2_domain();
    ASSERT_FALSE(domain) << bad;
    EXPECT_NE(domain.error().message.find(bad), std::string::npos);
  }
  ::unsetenv("ROS_DOMAIN_ID");
}

}  // namespace
}  // namespace scanfuse::drivers
