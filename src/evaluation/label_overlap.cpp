// SPDX-License-Identifier: BSD-3-Clause
#include "evaluation/label_overlap.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

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
    : counts{labelCount(areas), labelCount(rooms), {}} {
  counts.values.assign(counts.rows * counts.columns, 0);
  for (std::size_t i = 0; i < areas.size(); ++i) ++counts.at(areas[i], rooms[i]);
  area_size.assign(counts.rows, 0);
  room_size.assign(counts.columns, 0);
  for (std::size_t a = 0; a < counts.rows; ++a) {
    for (std::size_t r = 0; r < counts.columns; ++r) {
      area_size[a] += counts.at(a, r);
      room_size[r] += counts.at(a, r);
    }
  }
}

}  // namespace agrid
