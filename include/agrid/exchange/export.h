// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agrid/semantic_map.h"

namespace agrid {

/// Formats of other people's programs that a map can be written in (doc/formats.md).
enum class ExportFormat {
  kGeoJson,  ///< areas, doors and objects as features (RFC 7946)
  kNav2,     ///< route graph of Nav2's route server
  kGraphml,  ///< graph of areas, doors and objects
  kDot,      ///< the same for Graphviz
  kSvg,      ///< drawing in layers
  kLabels,   ///< 16-bit PNG: the area of each pixel
  kFacts     ///< Prolog
};

struct ExportFormatName {
  ExportFormat format;
  std::string_view name;    ///< in commands
  std::string_view ending;  ///< of files; no ending is that of two formats
};

inline constexpr std::array<ExportFormatName, 7> kExportFormats{{
    {ExportFormat::kGeoJson, "geojson", ".geojson"},
    {ExportFormat::kNav2, "nav2", ".nav2.geojson"},
    {ExportFormat::kGraphml, "graphml", ".graphml"},
    {ExportFormat::kDot, "dot", ".dot"},
    {ExportFormat::kSvg, "svg", ".svg"},
    {ExportFormat::kLabels, "labels", ".labels.png"},
    {ExportFormat::kFacts, "facts", ".pl"},
}};

/// The format whose ending, the longest if several fit, a file's name has; none without a stem.
std::optional<ExportFormat> formatOfFile(std::string_view file_name);

/// Finds a way that a robot can drive, straight from corner to corner, map frame [m]: both ends are
/// in it. Empty: there is none.
using WayFinder = std::function<std::vector<Point2>(const Point2& from_map, const Point2& to_map)>;

struct ExportParams {
  std::string frame_id = "map";  ///< name of the frame that all coordinates are in
  WayFinder find_way;            ///< for kNav2
};

/// A file as it is to be written.
struct Exported {
  std::string bytes;
  std::vector<std::string> warnings;  ///< what could not be written, and why
};

/// A map in another format. The same map gives the same bytes.
/// @throws std::invalid_argument if a route graph is asked for without `find_way`
Exported exportMap(const SemanticMap& map, ExportFormat format, const ExportParams& params);

}  // namespace agrid
