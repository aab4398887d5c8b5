// SPDX-License-Identifier: BSD-3-Clause
#include "areas/area_labels.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <utility>

#include "areas/paper_watershed.h"
#include "areas/seeded_flood.h"
#include "tags/default_name.h"
#include "tags/hand_over.h"
#include "tags/pixel_runs.h"

namespace agrid {
namespace {

constexpr std::uint32_t kNone = AreaLabels::kNone;
constexpr std::size_t kMaxAreas = std::numeric_limits<std::uint16_t>::max();

/// The area tags, those without an id given the lowest free ones, sorted by id.
std::vector<AreaTag> numberTags(const std::vector<Tag>& tags) {
  std::vector<AreaTag> areas;
  std::set<AreaId> used{AreaId{0}};
  for (const Tag& tag : tags) {
    const auto* area = std::get_if<AreaTag>(&tag);
    if (!area) continue;
    if (area->id != AreaId{0} && !used.insert(area->id).second) {
      throw std::invalid_argument("two area tags have the id " +
                                  std::to_string(static_cast<std::uint32_t>(area->id)));
    }
    areas.push_back(*area);
  }
  std::uint32_t next = 1;
  for (AreaTag& area : areas) {
    if (area.id != AreaId{0}) continue;
    while (used.count(AreaId{next}) > 0) ++next;
    area.id = AreaId{next++};
  }
  std::sort(areas.begin(), areas.end(),
            [](const AreaTag& a, const AreaTag& b) { return a.id < b.id; });
  return areas;
}

/// Moves the tags whose seed can be used into `labels`; returns their seeds' pixels.
std::vector<std::size_t> acceptSeeds(std::vector<AreaTag> tags, const Relief& relief,
                                     const MapGeometry& geometry, AreaLabels& labels) {
  std::vector<std::size_t> seeds;
  std::set<std::size_t> taken;
  for (AreaTag& tag : tags) {
    const auto pixel = geometry.pixelAt(tag.seed_map);
    const std::string label =
        "area tag " + std::to_string(static_cast<std::uint32_t>(tag.id)) + " '" + tag.name + "'";
    if (!pixel || relief.free_space(pixel->y, pixel->x) == 0) {
      labels.warnings.push_back(label + " lies outside free space and is not used");
    } else if (!taken.insert(geometry.index(*pixel)).second) {
      labels.warnings.push_back(label + " has the seed of another area and is not used");
    } else {
      seeds.push_back(geometry.index(*pixel));
      labels.tags.push_back(std::move(tag));
    }
  }
  return seeds;
}

/// How many free pixels each area has.
std::vector<std::size_t> sizesOf(const AreaLabels& labels, const OccupancyMap& map) {
  std::vector<std::size_t> sizes(labels.tags.size());
  const MapGeometry& geometry = map.geometry();
  for (int y = 0; y < geometry.height; ++y) {
    const Occupancy* pixels = map.pixels().data() + geometry.index({0, y});
    const std::uint32_t* row = labels.of_pixel.data() + geometry.index({0, y});
    forEachRun(row, geometry.width, [&](int begin, int end, std::uint32_t label) {
      if (label == kNone) return;
      const auto free = std::count(pixels + begin, pixels + end, Occupancy::kFree);
      sizes[label] += static_cast<std::size_t>(free);
    });
  }
  return sizes;
}

void nameAreas(std::vector<AreaTag>& tags) {
  std::set<std::string> used;
  for (const AreaTag& tag : tags) used.insert(tag.name);
  for (AreaTag& tag : tags) {
    if (!tag.name.empty()) continue;
    tag.name = defaultName("area", static_cast<std::uint32_t>(tag.id), used);
  }
}

int openingSide(const AreaParams& params, const MapGeometry& geometry) {
  return static_cast<int>(std::lround(params.passages.opening / geometry.resolution));
}

}  // namespace

std::vector<std::uint32_t> dropAreas(const OccupancyMap& map, AreaLabels& labels) {
  const std::size_t count = labels.tags.size();
  const std::vector<std::size_t> sizes = sizesOf(labels, map);
  std::vector<std::uint32_t> order(count);
  for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return sizes[a] > sizes[b]; });
  if (count > kMaxAreas) {
    labels.warnings.push_back("of " + std::to_string(count) + " areas the " +
                              std::to_string(count - kMaxAreas) + " smallest are left out");
  }
  while (!order.empty() && (order.size() > kMaxAreas || sizes[order.back()] == 0)) order.pop_back();
  if (order.size() == count) return {};
  std::sort(order.begin(), order.end());
  std::vector<std::uint32_t> new_label(count, kNone);
  std::uint32_t next = 0;
  for (const std::uint32_t old : order) new_label[old] = next++;
  relabel(new_label, labels);
  return new_label;
}

void relabel(const std::vector<std::uint32_t>& new_label, AreaLabels& labels) {
  std::vector<AreaTag> kept;
  for (std::size_t old = 0; old < new_label.size(); ++old) {
    if (new_label[old] != kNone) kept.push_back(std::move(labels.tags[old]));
  }
  labels.tags = std::move(kept);
  for (std::uint32_t& label : labels.of_pixel) {
    if (label != kNone) label = new_label[label];
  }
}

AreaLabels growAreas(const OccupancyMap& map, const Relief& relief, Division division,
                     const std::vector<Tag>& tags, const AreaParams& params) {
  AreaLabels labels;
  const MapGeometry& geometry = map.geometry();
  labels.openings = std::move(division.openings);
  const auto seeds = acceptSeeds(numberTags(tags), relief, geometry, labels);
  labels.of_pixel =
      params.method == AreaMethod::kPaper
          ? floodContours(relief.free_space, seeds, openingSide(params, geometry))
          : floodFromSeeds(std::move(division.basins), division.area_of, seeds, geometry.width);
  std::vector<std::size_t> doorways;
  for (const Barrier& barrier : relief.barriers) {
    doorways.insert(doorways.end(), barrier.pixels.begin(), barrier.pixels.end());
  }
  handOver(doorways, geometry, labels.of_pixel);
  dropAreas(map, labels);
  nameAreas(labels.tags);
  return labels;
}

}  // namespace agrid
