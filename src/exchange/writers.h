// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "agrid/exchange/export.h"

namespace agrid {

// The writers of one format each (doc/formats.md); all but the image in UTF-8.
std::string geoJsonText(const SemanticMap& map, const std::string& frame_id);
Exported routeGraphText(const SemanticMap& map, const ExportParams& params);
std::string graphmlText(const SemanticMap& map, const std::string& frame_id);
std::string dotText(const SemanticMap& map);
std::string svgText(const SemanticMap& map, const std::string& frame_id);
std::string factsText(const SemanticMap& map, const std::string& frame_id);
std::string labelsPng(const SemanticMap& map);

}  // namespace agrid
