# The ROS side of the package.
find_package(catkin REQUIRED COMPONENTS
  diagnostic_msgs geometry_msgs map_msgs message_generation nav_msgs nodelet pluginlib roscpp
  std_msgs std_srvs tf2_geometry_msgs tf2_ros visualization_msgs)

add_message_files(DIRECTORY msg FILES
  AGrid.msg Area.msg Door.msg Object.msg Route.msg Status.msg Tag.msg TopologicalGraph.msg)
add_service_files(DIRECTORY srv FILES
  AddTag.srv GetAGrid.srv GetGraph.srv LabelAt.srv ListTags.srv LoadMap.srv PlanAreas.srv
  PlanPath.srv Query.srv RemoveTag.srv SaveMap.srv SetDoor.srv WhereIs.srv)
generate_messages(DEPENDENCIES diagnostic_msgs geometry_msgs nav_msgs std_msgs)

catkin_package(
  INCLUDE_DIRS include
  LIBRARIES agrid agrid_map_ros
  CATKIN_DEPENDS diagnostic_msgs geometry_msgs map_msgs message_runtime nav_msgs nodelet pluginlib
                 roscpp std_msgs std_srvs tf2_geometry_msgs tf2_ros visualization_msgs
  DEPENDS EIGEN3 OpenCV)

function(agrid_add_ros_targets)
  file(GLOB _ros_sources CONFIGURE_DEPENDS src/ros/*.cpp)
  file(GLOB _nodelet_sources CONFIGURE_DEPENDS src/ros/*nodelet*.cpp)
  if(NOT _nodelet_sources)
    return()
  endif()
  list(REMOVE_ITEM _ros_sources ${_nodelet_sources} ${CMAKE_CURRENT_SOURCE_DIR}/src/ros/agrid_map_node.cpp)

  agrid_add_library(agrid_map_ros SHARED ${_ros_sources})
  agrid_add_library(agrid_map_nodelet SHARED ${_nodelet_sources})
  add_executable(agrid_map_node src/ros/agrid_map_node.cpp)
  agrid_set_warnings(agrid_map_node)
  foreach(_target agrid_map_ros agrid_map_nodelet agrid_map_node)
    target_include_directories(${_target} SYSTEM PUBLIC ${catkin_INCLUDE_DIRS})
    target_link_libraries(${_target} PUBLIC agrid ${catkin_LIBRARIES})
    add_dependencies(${_target} ${${PROJECT_NAME}_EXPORTED_TARGETS} ${catkin_EXPORTED_TARGETS})
  endforeach()
  target_link_libraries(agrid_map_nodelet PUBLIC agrid_map_ros)
  set_target_properties(agrid_map_node PROPERTIES
    RUNTIME_OUTPUT_DIRECTORY ${CATKIN_DEVEL_PREFIX}/lib/agrid_map)
endfunction()
