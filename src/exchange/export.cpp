// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/exchange/export.h"

#include <stdexcept>

#include <opencv2/imgcodecs.hpp>

#include "exchange/label_image.h"
#include "exchange/writers.h"

namespace agrid {

std::optional<ExportFormat> formatOfFile(std::string_view file_name) {
  const ExportFormatName* best = nullptr;
  for (const ExportFormatName& format : kExportFormats) {
    const std::size_t length = format.ending.size();
    if (file_name.size() <= length) continue;
    if (file_name.substr(file_name.size() - length) != format.ending) continue;
    if (best == nullptr || best->ending.size() < length) best = &format;
  }
  if (best == nullptr) return std::nullopt;
  return best->format;
}

std::string labelsPng(const SemanticMap& map) {
  std::vector<unsigned char> bytes;
  cv::imencode(".png", labelImage(map.area_map.pixel_labels.vector(), map.map().geometry()), bytes);
  return {bytes.begin(), bytes.end()};
}

Exported exportMap(const SemanticMap& map, ExportFormat format, const ExportParams& params) {
  switch (format) {
    case ExportFormat::kGeoJson:
      return {geoJsonText(map, params.frame_id), {}};
    case ExportFormat::kNav2:
      return routeGraphText(map, params);
    case ExportFormat::kGraphml:
      return {graphmlText(map, params.frame_id), {}};
    case ExportFormat::kDot:
      return {dotText(map), {}};
    case ExportFormat::kSvg:
      return {svgText(map, params.frame_id), {}};
    case ExportFormat::kLabels:
      return {labelsPng(map), {}};
    case ExportFormat::kFacts:
      return {factsText(map, params.frame_id), {}};
  }
  throw std::invalid_argument("format: " + std::to_string(static_cast<int>(format)) +
                              " is none of ExportFormat");
}

}  // namespace agrid
