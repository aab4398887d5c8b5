// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/areas/area_cost.h"

#include <limits>
#include <locale>
#include <optional>
#include <sstream>

namespace agrid {
namespace {

constexpr double kLeastCost = 1e-3;
constexpr double kGreatestCost = 1e3;

/// None for a bad one.
std::optional<double> costOf(const Properties& properties) {
  const auto cost = properties.find("cost");
  if (cost == properties.end()) return 1;
  if (cost->second == "forbidden" || cost->second == "inf") {
    return std::numeric_limits<double>::infinity();
  }
  std::istringstream text(cost->second);
  text.imbue(std::locale::classic());
  double value = 0;
  if (!(text >> value) || !(text >> std::ws).eof()) return std::nullopt;
  if (!(value >= kLeastCost && value <= kGreatestCost)) return std::nullopt;
  return value;
}

}  // namespace

double areaCost(const Properties& properties) { return costOf(properties).value_or(1); }

std::string costProblem(const Properties& properties) {
  if (costOf(properties)) return {};
  return "cost '" + properties.at("cost").substr(0, 64) +
         "' must be a number from 0.001 to 1000 or 'forbidden'";
}

std::vector<std::string> costWarnings(const std::vector<Area>& areas) {
  std::vector<std::string> warnings;
  for (const Area& area : areas) {
    const std::string problem = costProblem(area.properties);
    if (!problem.empty()) warnings.push_back("area '" + area.name + "': " + problem);
  }
  return warnings;
}

}  // namespace agrid
