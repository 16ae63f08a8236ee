"""Tracks a scan on ROS 2 and shows the tracks in RViz.

ros2 launch scanfuse.launch.py topic:=/scan preset:=road-users
"""
import os

from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration

HERE = os.path.dirname(os.path.abspath(__file__))


def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("topic", default_value="/scan",
                              description="LaserScan or PointCloud2"),
        DeclareLaunchArgument("preset", default_value="road-users",
                              description="Options to start from: scanfuse live --help"),
        DeclareLaunchArgument("name", default_value="scanfuse",
                              description="The topics are /NAME/tracks and /NAME/markers"),
        DeclareLaunchArgument("rviz", default_value="true",
                              description="Open RViz with scanfuse.rviz"),
        # No ROS node: a program that joins the bus itself, in the domain of ROS_DOMAIN_ID.
        ExecuteProcess(
            cmd=["scanfuse", "live", "--ros2",
                 "--topic", LaunchConfiguration("topic"),
                 "--preset", LaunchConfiguration("preset"),
                 "--ros2-name", LaunchConfiguration("name")],
            sigterm_timeout="5", output="screen"),
        ExecuteProcess(
            cmd=["rviz2", "-d", os.path.join(HERE, "scanfuse.rviz")],
            condition=IfCondition(LaunchConfiguration("rviz")), output="screen"),
    ])
