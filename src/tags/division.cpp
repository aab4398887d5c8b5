// SPDX-License-Identifier: BSD-3-Clause
#include "tags/division.h"

#include <utility>

#include "tags/border_merging.h"
#include "tags/fragments.h"
#include "tags/persistence.h"

namespace agrid {
namespace {

/// Names each area by its highest basin instead of any.
std::vector<std::uint32_t> byHighest(const std::vector<std::uint32_t>& area_of,
                                     const Basins& basins) {
  std::vector<std::uint32_t> highest = area_of;
  for (std::uint32_t i = 0; i < area_of.size(); ++i) {
    std::uint32_t& best = highest[area_of[i]];
    if (basins.basins[i].height > basins.basins[best].height) best = i;
  }
  std::vector<std::uint32_t> result(area_of.size());
  for (std::uint32_t i = 0; i < area_of.size(); ++i) result[i] = highest[area_of[i]];
  return result;
}

Division divideAtBorders(const Relief& relief, double resolution, const AreaParams& params) {
  Fragments fragments = cutIntoFragments(relief, resolution);
  const MapGeometry geometry{relief.free_space.cols, relief.free_space.rows, resolution, {}};
  const BorderSurvey survey(relief, fragments.openings, geometry);
  const auto& labels = fragments.basins.of_pixel;
  const auto stretches = splitIntoStretches(fragments.borders, geometry);
  RegionGraph graph(labels, fragments.basins.basins.size(), stretches, survey);
  auto area_of = byHighest(mergeByBorders(std::move(graph), params), fragments.basins);
  return {std::move(fragments.basins), std::move(area_of), std::move(fragments.openings)};
}

}  // namespace

Division divide(const Relief& relief, double resolution, const AreaParams& params) {
  if (params.method == AreaMethod::kPaper) return {};
  if (params.method == AreaMethod::kBorders) return divideAtBorders(relief, resolution, params);
  Division division;
  division.basins = findBasins(relief.height);
  division.area_of = mergeByPersistence(division.basins, resolution, params);
  return division;
}

}  // namespace agrid
