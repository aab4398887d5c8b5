// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "agrid/geometry/quaternion.h"
#include "agrid_map_ros/conversions.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

using agrid::MapError;
using agrid::MapErrorCode;

constexpr double kMaxTilt = 1e-3;       // [rad]
constexpr double kMaxNormError = 1e-3;  // of a quaternion

void checkSize(const nav_msgs::OccupancyGrid& map) {
  const std::uint64_t pixels = std::uint64_t{map.info.width} * map.info.height;
  if (pixels != map.data.size()) {
    throw MapError(MapErrorCode::kSize, "data has " + std::to_string(map.data.size()) +
                                            " values, width x height is " + std::to_string(pixels));
  }
}

void checkSides(const nav_msgs::MapMetaData& info, double max_pixels) {
  const std::string size = std::to_string(info.width) + " x " + std::to_string(info.height);
  if (info.width == 0 || info.height == 0) {
    throw MapError(MapErrorCode::kSize, "width x height is " + size + ", allowed from 1 x 1");
  }
  const std::uint64_t pixels = std::uint64_t{info.width} * info.height;
  constexpr std::uint64_t kLongestSide = std::numeric_limits<std::int32_t>::max();
  if (static_cast<double>(pixels) > max_pixels || info.width > kLongestSide ||
      info.height > kLongestSide) {
    throw MapError(MapErrorCode::kCap, "width x height is " + size + ", more than max_pixels " +
                                           formatNumber(max_pixels));
  }
}

double planarYaw(const geometry_msgs::Quaternion& orientation) {
  if (isZero(orientation)) return 0;
  const auto q = normalized(orientation);
  if (!q) {
    throw MapError(MapErrorCode::kOrigin, "origin's quaternion " + formatQuaternion(orientation) +
                                              " is not of norm 1 (at most 1e-3 off)");
  }
  // the angle between the map's z axis and the frame's
  const double tilt = 2 * std::asin(std::min(1.0, std::hypot(q->x, q->y)));
  if (tilt > kMaxTilt) {
    throw MapError(MapErrorCode::kOrigin, "origin is tilted by " + formatNumber(tilt) +
                                              " rad, allowed at most " + formatNumber(kMaxTilt));
  }
  return agrid::yawOfQuaternion(orientation.z, orientation.w);
}

}  // namespace

bool isZero(const geometry_msgs::Quaternion& q) {
  return q.x == 0 && q.y == 0 && q.z == 0 && q.w == 0;
}

std::optional<geometry_msgs::Quaternion> normalized(const geometry_msgs::Quaternion& q) {
  const double norm = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
  if (!(std::abs(norm - 1) <= kMaxNormError)) return std::nullopt;
  geometry_msgs::Quaternion unit = q;
  for (double* component : {&unit.x, &unit.y, &unit.z, &unit.w}) *component /= norm;
  return unit;
}

double yawOf(const geometry_msgs::Quaternion& q) {
  return std::atan2(2 * (q.w * q.z + q.x * q.y), 1 - 2 * (q.y * q.y + q.z * q.z));
}

std::string checkedFrame(const std::string& frame_id) {
  const std::string frame = withoutLeadingSlash(frame_id);
  if (frame.empty()) throw MapError(MapErrorCode::kFrame, "header.frame_id is empty");
  if (frame.size() > 256 || !isPrintable(frame)) {
    throw MapError(MapErrorCode::kFrame,
                   "header.frame_id '" + printable(frame.substr(0, 64)) + "' has " +
                       std::to_string(frame.size()) +
                       " bytes, allowed are 256 of UTF-8 without control characters");
  }
  return frame;
}

agrid::MapGeometry geometryFromMsg(const nav_msgs::MapMetaData& info, double max_pixels) {
  checkSides(info, max_pixels);
  const auto resolution = static_cast<double>(info.resolution);
  if (!(resolution >= 0.001 && resolution <= 10)) {
    throw MapError(MapErrorCode::kResolution,
                   "resolution is " + formatNumber(resolution) + ", allowed [0.001, 10] m");
  }
  const auto& position = info.origin.position;
  if (!(std::abs(position.x) <= 1e6 && std::abs(position.y) <= 1e6)) {
    throw MapError(MapErrorCode::kOrigin, "origin is (" + formatNumber(position.x) + ", " +
                                              formatNumber(position.y) +
                                              "), allowed at most 1e6 m from zero");
  }
  return {static_cast<int>(info.width), static_cast<int>(info.height), resolution,
          agrid::Pose2{{position.x, position.y}, planarYaw(info.origin.orientation)}};
}

void checkMap(const nav_msgs::OccupancyGrid& map, const agrid::MapParams& params) {
  checkedFrame(map.header.frame_id);
  geometryFromMsg(map.info, params.max_pixels);
  checkSize(map);
}

ReceivedMap fromMsg(const nav_msgs::OccupancyGrid& map, const agrid::MapParams& params) {
  ReceivedMap received;
  received.frame_id = checkedFrame(map.header.frame_id);
  received.grid.geometry = geometryFromMsg(map.info, params.max_pixels);
  checkSize(map);
  if (received.frame_id != map.header.frame_id) {
    received.warnings.push_back("header.frame_id starts with a slash, which is left out");
  }
  if (isZero(map.info.origin.orientation)) {
    received.warnings.push_back("the origin's quaternion is all zero and taken as no rotation");
  }
  received.grid.values.assign(map.data.begin(), map.data.end());
  return received;
}

nav_msgs::OccupancyGrid toMsg(const agrid::OccupancyMap& map, const std_msgs::Header& header) {
  const agrid::MapGeometry& geometry = map.geometry();
  nav_msgs::OccupancyGrid msg;
  msg.header = header;
  msg.info.map_load_time = header.stamp;
  msg.info.width = static_cast<std::uint32_t>(geometry.width);
  msg.info.height = static_cast<std::uint32_t>(geometry.height);
  msg.info.resolution = static_cast<float>(geometry.resolution);
  msg.info.origin = toMsg(geometry.map_from_image);
  msg.data.reserve(map.pixels().size());
  for (const agrid::Occupancy pixel : map.pixels()) {
    msg.data.push_back(static_cast<std::int8_t>(pixel == agrid::Occupancy::kFree       ? 0
                                                : pixel == agrid::Occupancy::kOccupied ? 100
                                                                                       : -1));
  }
  return msg;
}

nav_msgs::OccupancyGrid patched(const nav_msgs::OccupancyGrid& map,
                                const map_msgs::OccupancyGridUpdate& update) {
  if (withoutLeadingSlash(update.header.frame_id) != withoutLeadingSlash(map.header.frame_id)) {
    throw MapError(MapErrorCode::kFrame,
                   "the update's frame '" + printable(update.header.frame_id.substr(0, 64)) +
                       "' is not the map's '" + printable(map.header.frame_id) + "'");
  }
  const std::int64_t x = update.x;
  const std::int64_t y = update.y;
  const std::int64_t width = update.width;
  const std::int64_t height = update.height;
  const bool inside = x >= 0 && y >= 0 && width > 0 && height > 0 &&
                      x + width <= std::int64_t{map.info.width} &&
                      y + height <= std::int64_t{map.info.height};
  // inside the map the product is at most that of the map, so it cannot overflow
  if (!inside || static_cast<std::uint64_t>(width * height) != update.data.size()) {
    throw MapError(MapErrorCode::kSize,
                   "an update of " + std::to_string(width) + " x " + std::to_string(height) +
                       " at (" + std::to_string(x) + ", " + std::to_string(y) + ") with " +
                       std::to_string(update.data.size()) + " values does not fit a map of " +
                       std::to_string(map.info.width) + " x " + std::to_string(map.info.height));
  }
  nav_msgs::OccupancyGrid result = map;
  for (std::int64_t row = 0; row < height; ++row) {
    std::copy_n(update.data.begin() + row * width, width,
                result.data.begin() + (y + row) * std::int64_t{map.info.width} + x);
  }
  return result;
}

}  // namespace agrid_map_ros
