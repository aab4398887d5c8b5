// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "agrid/map/occupancy_map.h"

namespace agrid {

/// What went wrong with a file.
enum class FileErrorCode { kPath, kYaml, kImage, kIo };

/// A file that cannot be read or written; `what()` names the path and, where there is one, the key
/// and the line.
class FileError : public std::runtime_error {
 public:
  FileError(FileErrorCode code, const std::string& what) : std::runtime_error(what), code_(code) {}
  FileErrorCode code() const { return code_; }

 private:
  FileErrorCode code_;
};

/// A map_server map as read from its files.
struct LoadedMap {
  /// What a subscriber of map_server's message gets: resolution in single precision, yaw from the
  /// quaternion below.
  OccupancyGrid grid;
  float orientation_z = 0;  ///< of the origin's quaternion in map_server's message; x and y are 0
  float orientation_w = 1;
  std::vector<std::string> warnings;  ///< what was accepted but looks wrong
};

/// Which files may be read.
struct MapFileParams {
  std::string map_dir;  ///< if not empty, YAML and image must lie under it after resolving links
  double max_pixels = 1e9;  ///< larger images are refused before they are decoded
  /// Take an image by its colours alone where it is opaque everywhere; map_server averages the
  /// transparency with the colours (trinary mode), which moves the thresholds.
  bool skip_opaque_alpha = false;
};

/// Reads a map_server YAML file and its image, with the values that map_server publishes.
/// The image may be PNG, PGM, PPM, PBM or BMP; its path is relative to the YAML's folder.
/// Palette and 1-bit images are read by their colours, where map_server takes the indices.
/// @throws FileError; std::invalid_argument if `params.max_pixels` is not in [1, 1e18]
LoadedMap loadMap(const std::string& yaml_path, const MapFileParams& params = {});

/// Writes a map as map_saver does: `yaml_path` and, beside it and named like it, a PGM with free
/// pixels (0..25) 254, occupied ones (65..100) 0, all others 205. Numbers are written so that
/// loadMap gives them back (resolution and yaw in single precision, as in map_server's message).
/// Each file appears whole or not at all; one that was there is replaced.
/// @throws FileError if a file cannot be written, MapError if the size does not match the data
void saveMap(const OccupancyGrid& grid, const std::string& yaml_path);

}  // namespace agrid
