// SPDX-License-Identifier: BSD-3-Clause
#include "tools/truth_yaml.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>

#include <yaml-cpp/yaml.h>

#include "agrid/map/map_io.h"

namespace agrid::tools {
namespace {

constexpr std::size_t kMaxRooms = std::numeric_limits<std::uint16_t>::max();

/// A file, for messages.
struct YamlFile {
  const std::string& path;

  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    const std::string line = mark.is_null() ? "" : ":" + std::to_string(mark.line + 1);
    throw FileError(FileErrorCode::kYaml, path + line + ": " + what);
  }

  YAML::Node list() const {
    std::ifstream stream(path);
    if (!stream) throw FileError(FileErrorCode::kPath, path + ": " + std::strerror(errno));
    try {
      YAML::Node node = YAML::Load(stream);
      if (!node.IsSequence()) fail(node.Mark(), "is no list");
      return node;
    } catch (const YAML::Exception& error) {
      fail(error.mark, error.msg);
    }
  }

  YAML::Node entry(const YAML::Node& node, const char* key) const {
    if (!node.IsMap()) fail(node.Mark(), std::string("is nothing with a key '") + key + "'");
    const YAML::Node value = node[key];
    if (!value) fail(node.Mark(), std::string("no key '") + key + "'");
    return value;
  }

  Point2 point(const YAML::Node& node) const {
    if (!node.IsSequence() || node.size() != 2) fail(node.Mark(), "a point is [x, y]");
    Point2 p = Point2::Zero();
    for (std::size_t i = 0; i < 2; ++i) {
      double& value = p[static_cast<Eigen::Index>(i)];
      if (!YAML::convert<double>::decode(node[i], value) || !std::isfinite(value)) {
        fail(node.Mark(), "a point is [x, y], two finite numbers");
      }
    }
    return p;
  }
};

}  // namespace

std::vector<Polygon> readRoomPolygons(const std::string& path) {
  const YamlFile file{path};
  std::vector<Polygon> rooms;
  for (const YAML::Node& room : file.list()) {
    const YAML::Node corners = file.entry(room, "polygon");
    if (!corners.IsSequence() || corners.size() < 3) {
      file.fail(corners.Mark(), "polygon: needs three points or more");
    }
    Polygon& polygon = rooms.emplace_back();
    for (const YAML::Node& corner : corners) polygon.push_back(file.point(corner));
    if (rooms.size() > kMaxRooms) file.fail(room.Mark(), "more than 65535 rooms");
  }
  return rooms;
}

std::vector<Segment> readDoorCorners(const std::string& path) {
  const YamlFile file{path};
  std::vector<Segment> doors;
  for (const YAML::Node& door : file.list()) {
    doors.push_back({file.point(file.entry(door, "door_corner_pt_1")),
                     file.point(file.entry(door, "door_corner_pt_2"))});
  }
  return doors;
}

}  // namespace agrid::tools
