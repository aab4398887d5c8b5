# Messages and services of the package, and what it exports.
find_package(catkin REQUIRED COMPONENTS
  diagnostic_msgs dynamic_reconfigure geometry_msgs map_msgs message_generation nav_msgs nodelet
  pluginlib roscpp std_msgs std_srvs tf2_geometry_msgs tf2_ros visualization_msgs)

add_message_files(DIRECTORY msg FILES
  AGrid.msg Area.msg BlockedDoors.msg Door.msg Object.msg Route.msg Status.msg Tag.msg TopologicalGraph.msg)
add_service_files(DIRECTORY srv FILES
  AddTag.srv GetAGrid.srv GetGraph.srv LabelAt.srv ListTags.srv LoadMap.srv PlanAreas.srv
  PlanPath.srv Query.srv RemoveTag.srv SaveMap.srv SetDoor.srv WhereIs.srv)
generate_messages(DEPENDENCIES diagnostic_msgs geometry_msgs nav_msgs std_msgs)
generate_dynamic_reconfigure_options(cfg/AGrid.cfg)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES agrid agrid_map_ros
  CATKIN_DEPENDS diagnostic_msgs dynamic_reconfigure geometry_msgs map_msgs message_runtime
                 nav_msgs nodelet pluginlib roscpp std_msgs std_srvs tf2_geometry_msgs tf2_ros
                 visualization_msgs
  DEPENDS EIGEN3 OpenCV)
