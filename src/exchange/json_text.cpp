// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/json_text.h"

#include <cmath>

namespace agrid {

double rounded(double value) {
  const double result = std::round(value * 1e4) / 1e4;
  return result == 0 ? 0.0 : result;
}

Json jsonPoint(const Point2& point) { return {rounded(point.x()), rounded(point.y())}; }

std::string jsonText(const Json& json, int indent) {
  return json.dump(indent, ' ', false, Json::error_handler_t::replace);
}

Json jsonFrame(const std::string& frame_id) {
  std::string name;
  for (const char c : frame_id) name += c == '"' ? "\"\"" : std::string(1, c);
  const std::string wkt = "LOCAL_CS[\"" + name + "\",UNIT[\"metre\",1]]";
  return {{"type", "name"}, {"properties", {{"name", wkt}}}};
}

std::string jsonLines(const Json& array) {
  std::string text = "[";
  for (std::size_t i = 0; i < array.size(); ++i) {
    text += (i == 0 ? "\n  " : ",\n  ") + jsonText(array[i]);
  }
  return text + "]";
}

}  // namespace agrid
