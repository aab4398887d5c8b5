// SPDX-License-Identifier: BSD-3-Clause
#include "areas/joined_area.h"

#include <algorithm>

#include "areas/category_guess.h"
#include "areas/outline.h"

namespace agrid {
namespace {

/// As findRuns would return them.
std::vector<PixelRun> runsOf(const std::vector<std::uint16_t>& members,
                             const AutomaticAreas& automatic) {
  std::vector<PixelRun> all;
  for (const std::uint16_t label : members) {
    const auto& runs = automatic.runs[label - 1U];
    const auto middle = all.insert(all.end(), runs.begin(), runs.end());
    std::inplace_merge(all.begin(), middle, all.end(), [](const PixelRun& a, const PixelRun& b) {
      return a.y != b.y ? a.y < b.y : a.begin < b.begin;
    });
  }
  std::vector<PixelRun> runs;
  for (const PixelRun& run : all) {
    if (!runs.empty() && runs.back().y == run.y && runs.back().end == run.begin) {
      runs.back().end = run.end;
    } else {
      runs.push_back(run);
    }
  }
  return runs;
}

/// Whether a place lies farther from the walls than another, or as far and before it.
bool isBetterAnchor(const Area& a, const Area& b, const MapGeometry& geometry) {
  if (a.anchor_clearance != b.anchor_clearance) return a.anchor_clearance > b.anchor_clearance;
  const auto placeOf = [&](const Area& area) {
    const auto pixel = geometry.pixelAt(area.anchor_map);
    return pixel ? geometry.index(*pixel) : geometry.pixelCount();
  };
  return placeOf(a) < placeOf(b);
}

}  // namespace

Area joinedArea(const std::vector<std::uint16_t>& members, const AutomaticAreas& automatic,
                const MapGeometry& geometry) {
  Area joined;
  const Area* anchor = nullptr;
  double weighted_clearance = 0;
  for (const std::uint16_t label : members) {
    const Area& member = automatic.area_map.areas[label - 1U];
    if (!anchor || isBetterAnchor(member, *anchor, geometry)) anchor = &member;
    joined.size += member.size;
    weighted_clearance += member.size * automatic.mean_clearances[label - 1U];
  }
  joined.anchor_map = anchor->anchor_map;
  joined.anchor_clearance = anchor->anchor_clearance;
  std::vector<bool> is_member(automatic.area_map.areas.size() + 1, false);
  for (const std::uint16_t label : members) is_member[label] = true;
  joined.outline_map = traceOutline(runsOf(members, automatic), [&](const cv::Point& p) {
    const Pixel pixel{p.x, p.y};
    return geometry.contains(pixel) &&
           is_member[automatic.area_map.pixel_labels[geometry.index(pixel)]];
  });
  for (Point2& corner : joined.outline_map) {
    corner = geometry.map_from_image * (corner * geometry.resolution);
  }
  joined.category_guess =
      guessCategory({joined.size, weighted_clearance / joined.size, joined.anchor_clearance, 0});
  return joined;
}

}  // namespace agrid
