// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/label_overlap.h"

#include <algorithm>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace agrid {
namespace {

std::size_t labelCount(const Labels& labels) {
  return labels.empty() ? 1 : std::size_t{1} + *std::max_element(labels.begin(), labels.end());
}

}  // namespace

void checkSize(const char* field, const Labels& labels, const OccupancyMap& map) {
  if (labels.size() == map.pixels().size()) return;
  throw std::invalid_argument(std::string(field) + " has " + std::to_string(labels.size()) +
                              " pixels, the map has " + std::to_string(map.pixels().size()));
}

Labels compact(Labels labels, std::size_t min_pixels) {
  std::vector<std::size_t> sizes(std::numeric_limits<std::uint16_t>::max() + 1U, 0);
  for (const std::uint16_t label : labels) ++sizes[label];
  Labels renumbered(sizes.size(), 0);
  std::uint16_t next = 0;
  for (std::size_t i = 1; i < sizes.size(); ++i) {
    if (sizes[i] > min_pixels) renumbered[i] = ++next;
  }
  for (std::uint16_t& label : labels) label = renumbered[label];
  return labels;
}

Labels onFreePixels(Labels labels, const OccupancyMap& map) {
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (map.pixels()[i] != Occupancy::kFree) labels[i] = 0;
  }
  return labels;
}

LabelOverlap::LabelOverlap(const Labels& areas, const Labels& rooms)
    : of_area(labelCount(areas)), area_size(of_area.size(), 0), room_size(labelCount(rooms), 0) {
  std::map<std::pair<std::uint16_t, std::uint16_t>, std::size_t> counts;
  for (std::size_t begin = 0, end = 0; begin < areas.size(); begin = end) {
    while (end < areas.size() && areas[end] == areas[begin] && rooms[end] == rooms[begin]) ++end;
    counts[{areas[begin], rooms[begin]}] += end - begin;
  }
  for (const auto& [pair, count] : counts) {
    const auto [area, room] = pair;
    const auto pixels = static_cast<double>(count);
    area_size[area] += pixels;
    room_size[room] += pixels;
    if (room != 0) of_area[area].push_back({room, pixels});
  }
}

}  // namespace agrid
