// SPDX-License-Identifier: BSD-3-Clause
#include "agrid_map_ros/map_server.h"

#include <optional>
#include <utility>

#include <nav_msgs/LoadMap.h>

#include "ros/text.h"

namespace agrid_map_ros {
namespace {

using agrid::FileError;
using agrid::FileErrorCode;

std::optional<int> hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return std::nullopt;
}

[[noreturn]] void refuse(const std::string& url, const std::string& what) {
  throw FileError(FileErrorCode::kPath, printable(url.substr(0, 256)) + ": " + what);
}

std::string decoded(const std::string& text, const std::string& url) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      result += text[i];
      continue;
    }
    const auto high = i + 2 < text.size() ? hexDigit(text[i + 1]) : std::nullopt;
    const auto low = i + 2 < text.size() ? hexDigit(text[i + 2]) : std::nullopt;
    if (!high || !low) refuse(url, "% without two hexadecimal digits");
    result += static_cast<char>(16 * *high + *low);
    i += 2;
  }
  return result;
}

}  // namespace

nav_msgs::OccupancyGrid mapServerMessage(agrid::LoadedMap map, const std::string& frame_id) {
  const agrid::MapGeometry& geometry = map.grid.geometry;
  nav_msgs::OccupancyGrid message;
  message.header.frame_id = frame_id;
  message.info.width = static_cast<std::uint32_t>(geometry.width);
  message.info.height = static_cast<std::uint32_t>(geometry.height);
  message.info.resolution = static_cast<float>(geometry.resolution);
  message.info.origin.position.x = geometry.map_from_image.position.x();
  message.info.origin.position.y = geometry.map_from_image.position.y();
  message.info.origin.orientation.z = static_cast<double>(map.orientation_z);
  message.info.origin.orientation.w = static_cast<double>(map.orientation_w);
  message.data = std::move(map.grid.values);
  return message;
}

std::string pathOfUrl(const std::string& url) {
  const std::size_t colon = url.find("://");
  if (colon == std::string::npos || url.find('/') < colon) return url;
  if (url.substr(0, colon) != "file") refuse(url, "only file:// URLs and paths are read");
  const std::size_t host = colon + 3;
  const std::size_t path = url.find('/', host);
  if (path == std::string::npos) refuse(url, "a file:// URL without an absolute path");
  const std::string name = url.substr(host, path - host);
  if (!name.empty() && name != "localhost") refuse(url, "a file:// URL of another host");
  return decoded(url.substr(path), url);
}

std::uint8_t loadMapResult(agrid::FileErrorCode code) {
  using Response = nav_msgs::LoadMap::Response;
  switch (code) {
    case FileErrorCode::kPath:
      return Response::RESULT_MAP_DOES_NOT_EXIST;
    case FileErrorCode::kYaml:
      return Response::RESULT_INVALID_MAP_METADATA;
    case FileErrorCode::kImage:
      return Response::RESULT_INVALID_MAP_DATA;
    case FileErrorCode::kIo:
      break;
  }
  return Response::RESULT_UNDEFINED_FAILURE;
}

}  // namespace agrid_map_ros
