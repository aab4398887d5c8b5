// SPDX-License-Identifier: BSD-3-Clause
#include "agrid_map_ros/markers.h"

#include <algorithm>
#include <cmath>

#include "agrid_map_ros/conversions.h"

namespace agrid_map_ros {
namespace {

using visualization_msgs::Marker;

// heights that keep the layers apart [m]
constexpr double kAreaHeight = 0.01;
constexpr double kCellHeight = 0.02;
constexpr double kGraphHeight = 0.06;
constexpr double kDoorHeight = 0.08;
constexpr double kObjectHeight = 0.1;
constexpr double kPendingHeight = 0.12;
constexpr double kNameHeight = 0.5;
constexpr double kNameOffset = 0.4;  // along y [m]

/// How large a thing without a size is drawn [m].
constexpr double kLeastSize = 0.2;

std_msgs::ColorRGBA color(double r, double g, double b, double a) {
  std_msgs::ColorRGBA c;
  c.r = static_cast<float>(r);
  c.g = static_cast<float>(g);
  c.b = static_cast<float>(b);
  c.a = static_cast<float>(a);
  return c;
}

/// Well apart for neighbouring ids: the hue goes round by the golden ratio.
std_msgs::ColorRGBA areaColor(agrid::AreaId id) {
  const double hue = std::fmod(static_cast<double>(id) * 0.61803398875, 1.0) * 6;
  const auto channel = [hue](double shift) {
    const double k = std::fmod(hue + shift, 6.0);
    return 0.95 - 0.6 * std::clamp(std::min(k, 4 - k), 0.0, 1.0);
  };
  return color(channel(5), channel(3), channel(1), 0.45);
}

/// A list marker that goes on in another one when it is full.
class ListMarkers {
 public:
  ListMarkers(visualization_msgs::MarkerArray& array, const std_msgs::Header& header,
              const std::string& ns, int type, double scale)
      : array_(array) {
    model_.header = header;
    model_.ns = ns;
    model_.type = type;
    model_.pose.orientation.w = 1;
    model_.scale.x = scale;
    // lines have a width only, the other lists three sides
    const bool solid = type != Marker::LINE_LIST;
    model_.scale.y = solid ? scale : 0;
    model_.scale.z = solid ? scale : 0;
    model_.color = color(1, 1, 1, 1);
  }

  /// Adds points that belong together (both ends of a line ...), all of one colour.
  void add(const std::vector<agrid::Point2>& points_map, double height,
           const std_msgs::ColorRGBA& c) {
    if (current_ == kNone ||
        array_.markers[current_].points.size() + points_map.size() > kMaxMarkerPoints) {
      current_ = array_.markers.size();
      array_.markers.push_back(model_);
      ++model_.id;
    }
    Marker& marker = array_.markers[current_];
    for (const agrid::Point2& point : points_map) {
      marker.points.push_back(toMsg(point));
      marker.points.back().z = height;
      marker.colors.push_back(c);
    }
  }

  /// The id that a further marker of this namespace gets.
  void setNextId(int id) { model_.id = id; }
  int nextId() const { return model_.id; }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  visualization_msgs::MarkerArray& array_;
  Marker model_;
  std::size_t current_ = kNone;
};

void addCells(visualization_msgs::MarkerArray& array, const agrid::SemanticMap& map,
              const std_msgs::Header& header) {
  const agrid::AGrid& grid = map.grid();
  const agrid::Pose2& map_from_grid = grid.mapFromGrid();
  ListMarkers lines(array, header, "cells", Marker::LINE_LIST, 0.01);
  const std_msgs::ColorRGBA gray = color(0.45, 0.45, 0.5, 0.6);
  for (const double x : grid.x()) {
    lines.add({map_from_grid * agrid::Point2(x, grid.y().front()),
               map_from_grid * agrid::Point2(x, grid.y().back())},
              kCellHeight, gray);
  }
  for (const double y : grid.y()) {
    lines.add({map_from_grid * agrid::Point2(grid.x().front(), y),
               map_from_grid * agrid::Point2(grid.x().back(), y)},
              kCellHeight, gray);
  }
}

void addAreas(visualization_msgs::MarkerArray& array, const agrid::SemanticMap& map,
              const std_msgs::Header& header) {
  const agrid::AGrid& grid = map.grid();
  const agrid::Pose2& map_from_grid = grid.mapFromGrid();
  ListMarkers triangles(array, header, "areas", Marker::TRIANGLE_LIST, 1);
  const auto columns = static_cast<std::size_t>(grid.columns());
  const std::vector<agrid::AreaId>& labels = map.area_map.cell_areas;
  for (std::size_t begin = 0, end = 0; begin < labels.size(); begin = end) {
    // cells side by side in the same area make one rectangle
    const std::size_t row = begin / columns;
    end = begin + 1;
    while (end < (row + 1) * columns && labels[end] == labels[begin]) ++end;
    if (labels[begin] == agrid::AreaId{0}) continue;
    const double left = grid.x()[begin - row * columns];
    const double right = grid.x()[end - row * columns];
    const double low = grid.y()[row];
    const double high = grid.y()[row + 1];
    const agrid::Point2 a = map_from_grid * agrid::Point2(left, low);
    const agrid::Point2 b = map_from_grid * agrid::Point2(right, low);
    const agrid::Point2 c = map_from_grid * agrid::Point2(right, high);
    const agrid::Point2 d = map_from_grid * agrid::Point2(left, high);
    triangles.add({a, b, c, a, c, d}, kAreaHeight, areaColor(labels[begin]));
  }
}

void addDoors(visualization_msgs::MarkerArray& array, const agrid::SemanticMap& map,
              const std_msgs::Header& header) {
  ListMarkers lines(array, header, "doors", Marker::LINE_LIST, 0.1);
  for (const agrid::Door& door : map.area_map.doors) {
    const bool closed = door.state == agrid::DoorState::kClosed;
    const bool passage = door.kind == agrid::DoorKind::kPassage;
    const double lightness = closed ? 0 : passage ? 0.55 : 0.2;
    lines.add({door.jambs_map.a, door.jambs_map.b}, kDoorHeight,
              color(lightness, lightness, closed ? 0.5 : 1, 1));
  }
}

void addGraph(visualization_msgs::MarkerArray& array, const agrid::SemanticMap& map,
              const std_msgs::Header& header) {
  const std::vector<agrid::Area>& areas = map.area_map.areas;
  const std_msgs::ColorRGBA dark = color(0.15, 0.15, 0.15, 0.9);
  ListMarkers nodes(array, header, "graph", Marker::SPHERE_LIST, 0.25);
  for (const agrid::Area& area : areas) nodes.add({area.anchor_map}, kGraphHeight, dark);
  ListMarkers edges(array, header, "graph", Marker::LINE_LIST, 0.04);
  edges.setNextId(nodes.nextId());
  for (std::size_t i = 0; i < map.graph.passages.size(); ++i) {
    for (const agrid::Passage& passage : map.graph.passages[i]) {
      // each side of a door draws its own half
      edges.add({areas[i].anchor_map, map.area_map.doors[passage.door].jambs_map.midpoint()},
                kGraphHeight, dark);
    }
  }
}

/// The corners of a thing's bounding box, one after the other.
std::vector<agrid::Point2> cornersOf(const agrid::Pose2& pose_map, const agrid::Point2& size) {
  const agrid::Point2 half = size.cwiseAbs().cwiseMax(kLeastSize) / 2;
  return {pose_map * agrid::Point2(-half), pose_map * agrid::Point2(half.x(), -half.y()),
          pose_map * half, pose_map * agrid::Point2(-half.x(), half.y())};
}

bool isFinite(const agrid::Pose2& pose_map, const agrid::Point2& size) {
  return pose_map.position.allFinite() && std::isfinite(pose_map.yaw) && size.allFinite();
}

std::vector<agrid::Point2> outlineOf(const std::vector<agrid::Point2>& c) {
  return {c[0], c[1], c[1], c[2], c[2], c[3], c[3], c[0]};
}

void addObjects(visualization_msgs::MarkerArray& array, const agrid::SemanticMap& map,
                const std_msgs::Header& header) {
  ListMarkers faces(array, header, "objects", Marker::TRIANGLE_LIST, 1);
  for (const agrid::ObjectTag& object : map.knowledge.objects) {
    if (!isFinite(object.pose_map, object.size)) continue;
    const auto c = cornersOf(object.pose_map, object.size);
    faces.add({c[0], c[1], c[2], c[0], c[2], c[3]}, kObjectHeight, color(0.9, 0.1, 0.1, 0.4));
  }
  ListMarkers outlines(array, header, "objects", Marker::LINE_LIST, 0.04);
  outlines.setNextId(faces.nextId());
  for (const agrid::ObjectTag& object : map.knowledge.objects) {
    if (!isFinite(object.pose_map, object.size)) continue;
    outlines.add(outlineOf(cornersOf(object.pose_map, object.size)), kObjectHeight,
                 color(0.9, 0.1, 0.1, 1));
  }
}

/// What waits as lines: an area as a small box at its seed, a door from jamb to jamb.
struct PendingLines {
  std::vector<agrid::Point2> operator()(const agrid::AreaTag& area) const {
    return boxOf({area.seed_map, 0}, agrid::Point2::Zero());
  }
  std::vector<agrid::Point2> operator()(const agrid::DoorTag& door) const {
    const double half = std::max(door.width, kLeastSize) / 2;
    if (!isFinite(door.pose_map, {half, half})) return {};
    return {door.pose_map * agrid::Point2(0, -half), door.pose_map * agrid::Point2(0, half)};
  }
  std::vector<agrid::Point2> operator()(const agrid::ObjectTag& object) const {
    return boxOf(object.pose_map, object.size);
  }

 private:
  static std::vector<agrid::Point2> boxOf(const agrid::Pose2& pose_map, const agrid::Point2& size) {
    if (!isFinite(pose_map, size)) return {};
    return outlineOf(cornersOf(pose_map, size));
  }
};

void addPending(visualization_msgs::MarkerArray& array, const agrid::SemanticMap& map,
                const std_msgs::Header& header) {
  ListMarkers lines(array, header, "pending", Marker::LINE_LIST, 0.06);
  for (const agrid::PendingTag& pending : map.knowledge.pending) {
    // nobody knows how another frame lies to this one
    if (!pending.frame_id.empty() && pending.frame_id != header.frame_id) continue;
    const auto points = std::visit(PendingLines{}, pending.tag);
    if (!points.empty()) lines.add(points, kPendingHeight, color(1, 0.55, 0, 1));
  }
}

Marker nameMarker(const std_msgs::Header& header, const std::string& name,
                  const agrid::Point2& position_map) {
  Marker text;
  text.header = header;
  text.ns = "names";
  text.type = Marker::TEXT_VIEW_FACING;
  text.pose.orientation.w = 1;
  text.pose.position = toMsg(position_map);
  text.pose.position.y += kNameOffset;
  text.pose.position.z = kNameHeight;
  text.scale.z = 0.4;
  text.color = color(0, 0, 0, 1);
  text.text = name;
  return text;
}

void addNames(visualization_msgs::MarkerArray& array, const agrid::SemanticMap& map,
              const std_msgs::Header& header) {
  int id = 0;
  for (const agrid::Area& area : map.area_map.areas) {
    array.markers.push_back(nameMarker(header, area.name, area.anchor_map));
    array.markers.back().id = id++;
  }
  for (const agrid::ObjectTag& object : map.knowledge.objects) {
    if (!object.pose_map.position.allFinite()) continue;
    array.markers.push_back(nameMarker(header, object.name, object.pose_map.position));
    array.markers.back().id = id++;
    array.markers.back().scale.z = 0.25;
    array.markers.back().color = color(0.7, 0, 0, 1);
  }
}

}  // namespace

visualization_msgs::MarkerArray makeMarkers(const agrid::SemanticMap& map,
                                            const std_msgs::Header& header) {
  visualization_msgs::MarkerArray array;
  Marker clear;
  clear.header = header;
  clear.action = Marker::DELETEALL;
  clear.pose.orientation.w = 1;
  array.markers.push_back(clear);
  addAreas(array, map, header);
  addCells(array, map, header);
  addGraph(array, map, header);
  addDoors(array, map, header);
  addObjects(array, map, header);
  addPending(array, map, header);
  addNames(array, map, header);
  return array;
}

}  // namespace agrid_map_ros
