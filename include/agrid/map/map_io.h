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
  OccupancyGrid grid;
  std::vector<std::string> warnings;  ///< what was accepted but looks wrong
};

/// Which files may be read.
struct MapFileParams {
  std::string map_dir;  ///< if not empty, YAML and image must lie under it after resolving links
  double max_pixels = 1e9;  ///< larger images are refused before they are decoded
};

/// Reads a map_server YAML file and its image, with the values that map_server publishes.
/// The image may be PNG, PGM, PPM, PBM or BMP; its path is relative to the YAML's folder.
/// Palette and 1-bit images are read by their colours, where map_server takes the indices.
/// @throws FileError
LoadedMap loadMap(const std::string& yaml_path, const MapFileParams& params = {});

}  // namespace agrid
