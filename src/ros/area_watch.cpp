// SPDX-License-Identifier: BSD-3-Clause
#include "ros/area_watch.h"

#include "ros/boundary.h"
#include "ros/frames.h"
#include "ros/request_error.h"

namespace agrid_map_ros {
namespace {

/// The area a robot stands in: that of its pixel, or on a doorstep or a stray obstacle its cell's.
const agrid::Area* areaOf(const agrid::SemanticMap& map, const agrid::Point2& point_map) {
  if (const agrid::Area* area = agrid::areaAt(map, point_map)) return area;
  const auto cell = map.grid().cellAt(point_map);
  return cell ? agrid::findArea(map, map.area_map.cell_areas.at(map.grid().index(*cell))) : nullptr;
}

}  // namespace

AreaWatch::AreaWatch(ros::NodeHandle& private_nh, const Deps& deps, double period_seconds)
    : deps_(deps),
      publisher_(private_nh.advertise<agrid_map::Area>("current_area", 1, true)),
      timer_(private_nh.createSteadyTimer(ros::WallDuration(period_seconds),
                                          [this](const ros::SteadyTimerEvent&) {
                                            attempt(deps_.log, "current_area", [this] { look(); });
                                          })) {}

void AreaWatch::look() {
  const SnapshotPtr snapshot = deps_.keeper.snapshot();
  if (!snapshot) return;
  try {
    // nobody waits for an answer here, so what is not known yet is looked up next time
    const Frames frames(deps_.transforms, deps_.cancelled, snapshot->frame(), 0);
    const agrid::Pose2 pose = frames.robotPose(snapshot->parameters->node.base_frame);
    const agrid::Area* area = areaOf(*snapshot->map, pose.position);
    const agrid_map::Area message = area ? toMsg(*area) : agrid_map::Area{};
    // a new map may have changed what is known of the area
    const Seen seen{snapshot->stamp.version, message.id};
    if (last_ == seen) return;
    publisher_.publish(message);
    last_ = seen;
  } catch (const RequestError&) {
    // no transform: the robot has not told where it is
  }
}

}  // namespace agrid_map_ros
