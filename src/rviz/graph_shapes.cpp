// SPDX-License-Identifier: BSD-3-Clause
#include "graph_shapes.h"

#include <algorithm>
#include <cmath>

#include "places.h"

namespace agrid_map_rviz {
namespace {

using agrid_map::Door;
using agrid_map::Tag;
using geometry_msgs::Point;

/// How large a thing without a size is drawn [m].
constexpr double kLeastSize = 0.2;
constexpr Color kRed{0.9F, 0.1F, 0.1F, 1};
constexpr Color kOrange{1, 0.55F, 0, 1};
constexpr Color kViolet{0.6F, 0.1F, 0.75F, 0.8F};
constexpr Color kDark{0.15F, 0.15F, 0.15F, 0.9F};

Point pointAt(double x, double y) {
  Point point;
  point.x = x;
  point.y = y;
  return point;
}

Point middleOf(const Door& door) {
  return pointAt((door.jambs[0].x + door.jambs[1].x) / 2, (door.jambs[0].y + door.jambs[1].y) / 2);
}

bool isFinite(const geometry_msgs::Pose& pose) {
  return std::isfinite(pose.position.x) && std::isfinite(pose.position.y) &&
         std::isfinite(pose.orientation.z) && std::isfinite(pose.orientation.w);
}

/// A point of a pose's own frame, seen from above.
Point fromPose(const geometry_msgs::Pose& pose, double x, double y) {
  const auto& q = pose.orientation;
  const double yaw = std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
  return pointAt(pose.position.x + x * std::cos(yaw) - y * std::sin(yaw),
                 pose.position.y + x * std::sin(yaw) + y * std::cos(yaw));
}

std::vector<Point> cornersOf(const geometry_msgs::Pose& pose, const geometry_msgs::Vector3& size) {
  const double x = std::max(size.x, kLeastSize) / 2;
  const double y = std::max(size.y, kLeastSize) / 2;
  return {fromPose(pose, -x, -y), fromPose(pose, x, -y), fromPose(pose, x, y),
          fromPose(pose, -x, y)};
}

Color doorColor(const Door& door) {
  Color color{0.1F, 0.2F, 1, 1};
  if (door.state == Door::OPEN) color = {0, 0.6F, 0.15F, 1};
  if (door.state == Door::CLOSED) color = {0.75F, 0, 0.05F, 1};
  if (door.kind == Door::PASSAGE) {
    for (float* channel : {&color.r, &color.g, &color.b}) *channel += (1 - *channel) * 0.5F;
  }
  color.a = 0.35F + 0.65F * std::clamp(door.confidence, 0.0F, 1.0F);
  return color;
}

}  // namespace

Color areaColor(std::uint32_t id) {
  const double hue = std::fmod(static_cast<double>(id) * 0.61803398875, 1.0) * 6;
  const auto channel = [hue](double shift) {
    const double k = std::fmod(hue + shift, 6.0);
    return static_cast<float>(0.95 - 0.6 * std::clamp(std::min(k, 4 - k), 0.0, 1.0));
  };
  return {channel(5), channel(3), channel(1), 1};
}

Mesh doorShapes(const agrid_map::TopologicalGraph& graph) {
  Mesh mesh;
  for (const Door& door : graph.doors) {
    mesh.addStroke(door.jambs[0], door.jambs[1], 0.12, doorColor(door));
  }
  return mesh;
}

Mesh objectShapes(const agrid_map::TopologicalGraph& graph) {
  Mesh mesh;
  for (const agrid_map::Object& object : graph.objects) {
    if (!isFinite(object.pose)) continue;
    const auto corners = cornersOf(object.pose, object.size);
    mesh.addQuad(corners, {kRed.r, kRed.g, kRed.b, 0.4F});
    mesh.addOutline(corners, 0.04, kRed);
  }
  return mesh;
}

Mesh pendingShapes(const agrid_map::TopologicalGraph& graph) {
  Mesh mesh;
  for (const Tag& tag : graph.pending) {
    // nobody knows how another frame lies to this one
    const std::string& frame = tag.header.frame_id;
    if ((!frame.empty() && frame != graph.header.frame_id) || !isFinite(tag.pose)) continue;
    if (tag.type == Tag::DOOR) {
      const double half = std::max(tag.size.y, kLeastSize) / 2;
      mesh.addStroke(fromPose(tag.pose, 0, -half), fromPose(tag.pose, 0, half), 0.06, kOrange);
    } else {
      mesh.addOutline(cornersOf(tag.pose, tag.size), 0.06, kOrange);
    }
  }
  return mesh;
}

Mesh edgeShapes(const agrid_map::TopologicalGraph& graph) {
  Mesh mesh;
  for (const agrid_map::Area& area : graph.areas) mesh.addDisc(area.anchor, 0.12, kDark);
  for (const Door& door : graph.doors) {
    if (door.areas[0] == door.areas[1]) continue;
    for (const std::uint32_t id : door.areas) {
      const agrid_map::Area* area = find(graph.areas, id);
      if (area) mesh.addStroke(area->anchor, middleOf(door), 0.04, kDark);
    }
  }
  return mesh;
}

Mesh routeShapes(const agrid_map::TopologicalGraph& graph, const agrid_map::Route& route) {
  std::vector<Point> way;
  for (std::size_t i = 0; i < route.areas.size(); ++i) {
    if (const agrid_map::Area* area = find(graph.areas, route.areas[i]))
      way.push_back(area->anchor);
    const Door* door = i < route.doors.size() ? find(graph.doors, route.doors[i]) : nullptr;
    if (door) way.push_back(middleOf(*door));
  }
  Mesh mesh;
  for (std::size_t i = 1; i < way.size(); ++i) mesh.addStroke(way[i - 1], way[i], 0.16, kViolet);
  return mesh;
}

Mesh planShapes(const nav_msgs::Path& plan) {
  Mesh mesh;
  for (std::size_t i = 1; i < plan.poses.size(); ++i) {
    mesh.addStroke(plan.poses[i - 1].pose.position, plan.poses[i].pose.position, 0.08, kRed);
  }
  return mesh;
}

Mesh cellShapes(const agrid_map::AGrid& grid) {
  Mesh mesh;
  if (grid.x.empty() || grid.y.empty()) return mesh;
  const Color gray{0.45F, 0.45F, 0.5F, 0.6F};
  for (const double x : grid.x) {
    mesh.addLine(pointAt(x, grid.y.front()), pointAt(x, grid.y.back()), gray);
  }
  for (const double y : grid.y) {
    mesh.addLine(pointAt(grid.x.front(), y), pointAt(grid.x.back(), y), gray);
  }
  return mesh;
}

}  // namespace agrid_map_rviz
