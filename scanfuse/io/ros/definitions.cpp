#include "scanfuse/io/ros/definitions.hpp"

#include <map>
#include <vector>

namespace scanfuse::io::ros {

namespace {

struct Definition {
  std::string fields;
  std::vector<std::string> parts;  ///< every type below it, in order of first use
};

const std::map<std::string, std::string>& part_fields() {
  static const std::map<std::string, std::string> parts{
      {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
      {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Quaternion", "float64 x 0\nfloat64 y 0\nfloat64 z 0\nfloat64 w 1\n"},
      {"geometry_msgs/Pose",
       "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
      {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
      {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
      {"geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist twist\nfloat64[36] covariance\n"},
      {"geometry_msgs/Transform",
       "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
      {"geometry_msgs/TransformStamped",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
      {"sensor_msgs/PointField",
       "uint8 INT8=1\nuint8 UINT8=2\nuint8 INT16=3\nuint8 UINT16=4\nuint8 INT32=5\n"
       "uint8 UINT32=6\nuint8 FLOAT32=7\nuint8 FLOAT64=8\n"
       "string name\nuint32 offset\nuint8 datatype\nuint32 count\n"},
      {"std_msgs/ColorRGBA", "float32 r\nfloat32 g\nfloat32 b\nfloat32 a\n"},
      {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"},
      {"sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"},
      {"visualization_msgs/UVCoordinate", "float32 u\nfloat32 v\n"},
      {"visualization_msgs/MeshFile", "string filename\nuint8[] data\n"},
      {"visualization_msgs/Marker",
       "int32 CUBE=1\nint32 TEXT_VIEW_FACING=9\nint32 ADD=0\nint32 DELETEALL=3\n"
       "std_msgs/Header header\nstring ns\nint32 id\nint32 type\nint32 action\n"
       "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 scale\nstd_msgs/ColorRGBA color\n"
       "builtin_interfaces/Duration lifetime\nbool frame_locked\n"
       "geometry_msgs/Point[] points\nstd_msgs/ColorRGBA[] colors\n"
       "string texture_resource\nsensor_msgs/CompressedImage texture\n"
       "visualization_msgs/UVCoordinate[] uv_coordinates\nstring text\n"
       "string mesh_resource\nvisualization_msgs/MeshFile mesh_file\n"
       "bool mesh_use_embedded_materials\n"},
      {"vision_msgs/ObjectHypothesis", "string class_id\nfloat64 score\n"},
      {"vision_msgs/ObjectHypothesisWithPose",
       "vision_msgs/ObjectHypothesis hypothesis\ngeometry_msgs/PoseWithCovariance pose\n"},
      {"vision_msgs/BoundingBox3D", "geometry_msgs/Pose center\ngeometry_msgs/Vector3 size\n"},
      {"vision_msgs/Detection3D",
       "std_msgs/Header header\nvision_msgs/ObjectHypothesisWithPose[] results\n"
       "vision_msgs/BoundingBox3D bbox\nstring id\n"},
      {"diagnostic_msgs/KeyValue", "string key\nstring value\n"},
      {"diagnostic_msgs/DiagnosticStatus",
       "byte OK=0\nbyte WARN=1\nbyte ERROR=2\nbyte STALE=3\n"
       "byte level\nstring name\nstring message\nstring hardware_id\n"
       "diagnostic_msgs/KeyValue[] values\n"},
  };
  return parts;
}

const std::map<std::string, Definition>& written_types() {
  static const std::map<std::string, Definition> types{
      {"sensor_msgs/msg/LaserScan",
       {"std_msgs/Header header\nfloat32 angle_min\nfloat32 angle_max\nfloat32 angle_increment\n"
        "float32 time_increment\nfloat32 scan_time\nfloat32 range_min\nfloat32 range_max\n"
        "float32[] ranges\nfloat32[] intensities\n",
        {"std_msgs/Header", "builtin_interfaces/Time"}}},
      {"sensor_msgs/msg/PointCloud2",
       {"std_msgs/Header header\nuint32 height\nuint32 width\nsensor_msgs/PointField[] fields\n"
        "bool is_bigendian\nuint32 point_step\nuint32 row_step\nuint8[] data\nbool is_dense\n",
        {"std_msgs/Header", "builtin_interfaces/Time", "sensor_msgs/PointField"}}},
      {"nav_msgs/msg/Odometry",
       {"std_msgs/Header header\nstring child_frame_id\n"
        "geometry_msgs/PoseWithCovariance pose\ngeometry_msgs/TwistWithCovariance twist\n",
        {"std_msgs/Header", "builtin_interfaces/Time", "geometry_msgs/PoseWithCovariance",
         "geometry_msgs/Pose", "geometry_msgs/Point", "geometry_msgs/Quaternion",
         "geometry_msgs/TwistWithCovariance", "geometry_msgs/Twist", "geometry_msgs/Vector3"}}},
      {"tf2_msgs/msg/TFMessage",
       {"geometry_msgs/TransformStamped[] transforms\n",
        {"geometry_msgs/TransformStamped", "std_msgs/Header", "builtin_interfaces/Time",
         "geometry_msgs/Transform", "geometry_msgs/Vector3", "geometry_msgs/Quaternion"}}},
      {"visualization_msgs/msg/MarkerArray",
       {"visualization_msgs/Marker[] markers\n",
        {"visualization_msgs/Marker", "std_msgs/Header", "builtin_interfaces/Time",
         "geometry_msgs/Pose", "geometry_msgs/Point", "geometry_msgs/Quaternion",
         "geometry_msgs/Vector3", "std_msgs/ColorRGBA", "builtin_interfaces/Duration",
         "sensor_msgs/CompressedImage", "visualization_msgs/UVCoordinate",
         "visualization_msgs/MeshFile"}}},
      {"vision_msgs/msg/Detection3DArray",
       {"std_msgs/Header header\nvision_msgs/Detection3D[] detections\n",
        {"std_msgs/Header", "builtin_interfaces/Time", "vision_msgs/Detection3D",
         "vision_msgs/ObjectHypothesisWithPose", "vision_msgs/ObjectHypothesis",
         "geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose", "geometry_msgs/Point",
         "geometry_msgs/Quaternion", "vision_msgs/BoundingBox3D", "geometry_msgs/Vector3"}}},
      {"diagnostic_msgs/msg/DiagnosticArray",
       {"std_msgs/Header header\ndiagnostic_msgs/DiagnosticStatus[] status\n",
        {"std_msgs/Header", "builtin_interfaces/Time", "diagnostic_msgs/DiagnosticStatus",
         "diagnostic_msgs/KeyValue"}}},
      {"sensor_msgs/msg/Imu",
       {"std_msgs/Header header\ngeometry_msgs/Quaternion orientation\n"
        "float64[9] orientation_covariance\ngeometry_msgs/Vector3 angular_velocity\n"
        "float64[9] angular_velocity_covariance\ngeometry_msgs/Vector3 linear_acceleration\n"
        "float64[9] linear_acceleration_covariance\n",
        {"std_msgs/Header", "builtin_interfaces/Time", "geometry_msgs/Quaternion",
         "geometry_msgs/Vector3"}}},
  };
  return types;
}

}  // namespace

std::string definition_of(const std::string& type) {
  const auto found = written_types().find(type);
  if (found == written_types().end()) return {};
  std::string text = found->second.fields;
  for (const auto& part : found->second.parts) {
    text += std::string(80, '=') + "\nMSG: " + part + "\n" + part_fields().at(part);
  }
  return text;
}

}  // namespace scanfuse::io::ros
