// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <filesystem>
#include <stdexcept>

#include "agrid/geometry/quaternion.h"
#include "agrid/map/map_io.h"
#include "map/file_reader.h"
#include "map/image.h"
#include "map/map_yaml.h"
#include "map/pixel_values.h"
#include "map/printable.h"

namespace agrid {
namespace {

constexpr std::size_t kLongestYaml = 65536;  // bytes

std::string yamlText(const std::string& path, const std::string& map_dir) {
  FileReader file(path, map_dir);
  std::string text(kLongestYaml + 1, '\0');
  text.resize(file.read(reinterpret_cast<std::uint8_t*>(text.data()), text.size()));
  if (text.size() > kLongestYaml) {
    throw FileError(FileErrorCode::kYaml, printable(path) + ":1:1: longer than " +
                                              std::to_string(kLongestYaml) + " bytes");
  }
  return text;
}

}  // namespace

LoadedMap loadMap(const std::string& yaml_path, const MapFileParams& params) {
  if (!(params.max_pixels >= 1 && params.max_pixels <= 1e18)) {
    throw std::invalid_argument("max_pixels is " + std::to_string(params.max_pixels) +
                                ", must be in [1, 1e18]");
  }
  MapYaml yaml = parseMapYaml(yamlText(yaml_path, params.map_dir), printable(yaml_path));
  const auto folder = std::filesystem::path(yaml_path).parent_path();
  FileReader file((folder / yaml.image).string(), params.map_dir);
  Image image = readImage(file, params.max_pixels);

  LoadedMap map;
  // As in Bullet's single precision, which map_server uses.
  const float half_yaw = static_cast<float>(yaml.origin[2]) * 0.5f;
  map.orientation_z = std::sin(half_yaw);
  map.orientation_w = std::cos(half_yaw);
  map.grid.geometry = {image.width,
                       image.height,
                       static_cast<double>(static_cast<float>(yaml.resolution)),
                       {Point2(yaml.origin[0], yaml.origin[1]),
                        yawOfQuaternion(map.orientation_z, map.orientation_w)}};
  yaml.rule.skip_opaque_alpha = params.skip_opaque_alpha;
  map.grid.values = pixelValues(image, yaml.rule);
  for (const std::string& warning : yaml.warnings) {
    map.warnings.push_back(printable(yaml_path) + ": " + warning);
  }
  for (const std::string& warning : image.warnings) {
    map.warnings.push_back(printable(yaml.image) + ": " + warning);
  }
  return map;
}

}  // namespace agrid
