// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/place_files.h"

#include <cmath>
#include <limits>

#include "exchange/polygon_labels.h"
#include "exchange/yaml_list.h"

namespace agrid {
namespace {

constexpr std::size_t kMostAreas = std::numeric_limits<std::uint16_t>::max();
constexpr double kPi = 3.14159265358979323846;

/// Corners [x1, y1, x2, y2, ...] of an image (y down), in pixels of the image frame.
Polygon readFlatPolygon(const YamlFile& file, const YAML::Node& numbers, const MapGeometry& map) {
  if (!numbers.IsSequence() || numbers.size() < 6 || numbers.size() % 2 != 0) {
    file.fail(numbers.Mark(), "polygons: one is [x1, y1, x2, y2, ...], three points or more");
  }
  Polygon polygon;
  for (std::size_t i = 0; i < numbers.size(); i += 2) {
    polygon.emplace_back(file.number(numbers[i]), map.height - file.number(numbers[i + 1]));
  }
  return polygon;
}

}  // namespace

std::vector<PlaceDoor> readPlaceDoors(const std::string& path) {
  const YamlFile file(path);
  std::vector<PlaceDoor> doors;
  for (const YAML::Node& node : file.list()) {
    PlaceDoor door;
    door.jambs_map = {file.point(file.entry(node, "door_corner_pt_1")),
                      file.point(file.entry(node, "door_corner_pt_2"))};
    if (door.jambs_map.length() == 0) file.fail(node.Mark(), "both corners of the door are one");
    if (YamlFile::has(node, "name")) door.name = file.name(node["name"]);
    doors.push_back(std::move(door));
  }
  return doors;
}

DoorTag tagOf(const PlaceDoor& door) {
  const Point2 along = door.jambs_map.b - door.jambs_map.a;
  DoorTag tag;
  tag.name = door.name;
  tag.pose_map = {door.jambs_map.midpoint(), std::atan2(along.y(), along.x()) - kPi / 2};
  tag.width = door.jambs_map.length();
  tag.source = TagSource::kManual;
  return tag;
}

void readLocations(const std::string& path, const OccupancyMap& map, GivenPlace& place) {
  const YamlFile file(path);
  const YAML::Node root = file.load();
  const YAML::Node names = file.entry(root, "locations");
  const YAML::Node polygons = file.entry(root, "polygons");
  if (!names.IsSequence() || !polygons.IsSequence() || names.size() != polygons.size()) {
    file.fail(polygons.Mark(), "polygons: there must be one for each of 'locations'");
  }
  if (names.size() > kMostAreas) file.fail(names.Mark(), "more than 65535 locations");
  place.labels.assign(map.geometry().pixelCount(), 0);
  place.areas.clear();
  for (std::size_t k = 0; k < names.size(); ++k) {
    place.areas.push_back({file.name(names[k]), {}, {}});
    paintPolygon({readFlatPolygon(file, polygons[k], map.geometry())},
                 static_cast<std::uint16_t>(k + 1), map, place.labels);
  }
}

std::vector<ObjectTag> readPlaceObjects(const std::string& path) {
  const YamlFile file(path);
  std::vector<ObjectTag> objects;
  for (const YAML::Node& node : file.list()) {
    const YAML::Node pose = file.entry(node, "point");
    if (!pose.IsSequence() || pose.size() != 3) file.fail(pose.Mark(), "point: is [x, y, yaw]");
    ObjectTag object;
    object.name = file.name(file.entry(node, "name"));
    object.pose_map = {{file.number(pose[0]), file.number(pose[1])}, file.number(pose[2])};
    object.source = TagSource::kManual;
    objects.push_back(std::move(object));
  }
  return objects;
}

}  // namespace agrid
