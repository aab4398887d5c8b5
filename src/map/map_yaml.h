// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

namespace agrid {

/// How map_server turns greys into occupancy values.
enum class PixelMode { kTrinary, kScale, kRaw };

struct PixelRule {
  PixelMode mode = PixelMode::kTrinary;
  bool negate = false;             ///< black is free
  double occupied_thresh = 0.65;   ///< darker is occupied, 0 white to 1 black
  double free_thresh = 0.196;      ///< lighter is free
  bool skip_opaque_alpha = false;  ///< see MapFileParams
};

/// The contents of a map_server YAML file.
struct MapYaml {
  std::string image;               ///< path as written
  double resolution = 0;           ///< [m]
  std::array<double, 3> origin{};  ///< x [m], y [m], yaw [rad] of the image's lower left corner
  PixelRule rule;
  std::vector<std::string> warnings;
};

/// Reads the text of a map_server YAML file.
/// @param name  for messages
/// @throws FileError (kYaml) naming line, column and key
MapYaml parseMapYaml(const std::string& text, const std::string& name);

}  // namespace agrid
