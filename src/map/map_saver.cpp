// SPDX-License-Identifier: BSD-3-Clause
#include <cstdint>
#include <filesystem>
#include <iomanip>
#include <locale>
#include <sstream>
#include <string>
#include <vector>

#include "agrid/map/map_io.h"
#include "map/file_writer.h"
#include "map/printable.h"

namespace agrid {
namespace {

// The fewest decimals that read back as the same number, without an exponent, in any locale.
template <typename Number>
std::string decimal(Number number) {
  constexpr int kMostDecimals = 1100;  // the smallest number in full has 1074
  for (int decimals = 0;; ++decimals) {
    std::stringstream text;
    text.imbue(std::locale::classic());
    text << std::fixed << std::setprecision(decimals) << number;
    const std::string written = text.str();
    Number read = 0;
    text >> read;
    if (read == number || decimals == kMostDecimals) return written;
  }
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

// map_saver's grey levels, under its default thresholds.
std::uint8_t greyOf(std::int8_t value) {
  if (value >= 0 && value <= 25) return 254;
  return value >= 65 ? 0 : 205;
}

void writePgm(const OccupancyGrid& grid, const std::string& path) {
  const MapGeometry& g = grid.geometry;
  FileWriter file(path);
  file.write("P5\n# CREATOR: agrid_map " + decimal(static_cast<float>(g.resolution)) + " m/pix\n" +
             std::to_string(g.width) + ' ' + std::to_string(g.height) + "\n255\n");
  std::vector<std::uint8_t> row(static_cast<std::size_t>(g.width));
  for (int y = g.height - 1; y >= 0; --y) {
    const std::int8_t* values = grid.values.data() + g.index({0, y});
    for (std::size_t x = 0; x < row.size(); ++x) row[x] = greyOf(values[x]);
    file.write(row.data(), row.size());
  }
  file.commit();
}

void writeYaml(const MapGeometry& g, const std::string& path, const std::string& image) {
  const Pose2& origin = g.map_from_image;
  FileWriter file(path);
  file.write("image: " + quoted(image) +
             "\nresolution: " + decimal(static_cast<float>(g.resolution)) + "\norigin: [" +
             decimal(origin.position.x()) + ", " + decimal(origin.position.y()) + ", " +
             decimal(static_cast<float>(origin.yaw)) +
             "]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n");
  file.commit();
}

}  // namespace

void saveMap(const OccupancyGrid& grid, const std::string& yaml_path) {
  const MapGeometry& g = grid.geometry;
  if (g.width <= 0 || g.height <= 0 || grid.values.size() != g.pixelCount()) {
    throw MapError(MapErrorCode::kSize, "map of " + std::to_string(g.width) + " x " +
                                            std::to_string(g.height) + " pixels with " +
                                            std::to_string(grid.values.size()) +
                                            " values cannot be saved");
  }
  for (const char c : yaml_path) {
    if (static_cast<unsigned char>(c) < 0x20) {
      throw FileError(FileErrorCode::kPath,
                      printable(yaml_path) + ": control characters cannot be in a map's name");
    }
  }
  const std::filesystem::path path(yaml_path);
  const bool usual = path.extension() == ".yaml" || path.extension() == ".yml";
  const std::string image = (usual ? path.stem().string() : path.filename().string()) + ".pgm";
  writePgm(grid, (path.parent_path() / image).string());
  writeYaml(g, yaml_path, image);  // last: a YAML file never names an image that is not there
}

}  // namespace agrid
