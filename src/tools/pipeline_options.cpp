// SPDX-License-Identifier: BSD-3-Clause
#include "tools/pipeline_options.h"

#include <cmath>
#include <map>
#include <string>
#include <variant>

namespace agrid::tools {
namespace {

using Field = std::variant<double*, int*, bool*, AreaMethod*>;

std::map<std::string, Field> fields(ConversionParams& params) {
  WallParams& walls = params.pipeline.walls;
  AreaParams& areas = params.pipeline.areas;
  PassageParams& passages = areas.passages;
  return {
      {"free_max", &params.map.free_max},
      {"occupied_min", &params.map.occupied_min},
      {"max_pixels", &params.map.max_pixels},
      {"canny_low", &walls.canny_low},
      {"canny_high", &walls.canny_high},
      {"max_threshold", &walls.max_threshold_votes},
      {"min_threshold", &walls.min_threshold_votes},
      {"threshold_step", &walls.threshold_step_votes},
      {"min_line_distance", &walls.min_line_distance_px},
      {"distance_resolution", &walls.distance_resolution_px},
      {"estimate_direction", &walls.estimate_direction},
      {"direction", &walls.direction_deg},
      {"max_cells", &params.pipeline.grid.max_cells},
      {"area_method", &areas.method},
      {"max_clutter_diagonal", &areas.max_clutter_diagonal},
      {"min_island_size", &areas.min_island_size},
      {"min_separation", &areas.min_separation},
      {"merge_ratio", &areas.merge_ratio},
      {"min_prominence", &areas.min_prominence},
      {"min_area_size", &areas.min_area_size},
      {"min_area_clearance", &areas.min_area_clearance},
      {"max_door_width", &areas.max_door_width},
      {"min_border_length", &areas.min_border_length},
      {"passage_min_width", &passages.min_width},
      {"passage_max_width", &passages.max_width},
      {"passage_max_skew", &passages.max_skew_deg},
      {"passage_min_spacing", &passages.min_spacing},
      {"passage_support_reach", &passages.support_reach},
      {"passage_min_support", &passages.min_support},
      {"passage_opening", &passages.opening},
  };
}

/// Stores a text where its parameter lies; false if it is no value of that kind.
struct Store {
  const std::string& text;

  bool operator()(double* field) const {
    const auto number = parseNumber(text);
    if (number) *field = *number;
    return number.has_value();
  }
  bool operator()(int* field) const {
    const auto number = parseNumber(text);
    if (!number || *number != std::floor(*number) || std::abs(*number) > 1e9) return false;
    *field = static_cast<int>(*number);
    return true;
  }
  bool operator()(bool* field) const {
    if (text != "true" && text != "false") return false;
    *field = text == "true";
    return true;
  }
  bool operator()(AreaMethod* field) const {
    const auto* name = std::find(kAreaMethodNames.begin(), kAreaMethodNames.end(), text);
    if (name == kAreaMethodNames.end()) return false;
    *field = static_cast<AreaMethod>(name - kAreaMethodNames.begin());
    return true;
  }
};

}  // namespace

std::vector<Option> pipelineOptions() {
  return {
      {"method", 0, "NAME", "how areas are found: borders (default), persistence or paper", false,
       false},
      {"param", 'p', "KEY=VALUE", "set a parameter; may be given many times", false, true},
  };
}

ConversionParams conversionParams(const Arguments& arguments) {
  ConversionParams params;
  const auto known = fields(params);
  std::vector<std::string> settings = arguments.values("param");
  if (arguments.has("method")) settings.push_back("area_method=" + arguments.value("method"));
  for (const std::string& setting : settings) {
    const auto equals = setting.find('=');
    if (equals == std::string::npos) throw UsageError("'" + setting + "' is not KEY=VALUE");
    const std::string key = setting.substr(0, equals);
    const auto field = known.find(key);
    if (field == known.end()) {
      std::string keys;
      for (const auto& [name, unused] : known) keys += " " + name;
      throw UsageError("there is no parameter '" + key + "'; there are" + keys);
    }
    const std::string text = setting.substr(equals + 1);
    if (!std::visit(Store{text}, field->second)) {
      throw UsageError("'" + text + "' is no value of the parameter '" + key + "'");
    }
  }
  return params;
}

}  // namespace agrid::tools
