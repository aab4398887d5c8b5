// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/evaluation/scores.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "evaluation/assignment.h"
#include "evaluation/room_borders.h"

namespace agrid {
namespace {

constexpr std::size_t kMinPixels = 100;
constexpr double kMinBorder = 0.2;  // [m]
using Labels = std::vector<std::uint16_t>;

void checkSize(const char* field, const Labels& labels, const OccupancyMap& map) {
  if (labels.size() == map.pixels().size()) return;
  throw std::invalid_argument(std::string(field) + " has " + std::to_string(labels.size()) +
                              " pixels, the map has " + std::to_string(map.pixels().size()));
}

/// Renumbers labels from 1 without gaps, those of at most `min_pixels` become 0.
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

/// Pixels that each area (row) and each room (column) have in common; row and column 0: none.
struct Overlap {
  Overlap(const Labels& areas, const Labels& rooms)
      : counts{std::size_t{1} + *std::max_element(areas.begin(), areas.end()),
               std::size_t{1} + *std::max_element(rooms.begin(), rooms.end()),
               {}} {
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
  std::size_t areas() const { return counts.rows - 1; }
  std::size_t rooms() const { return counts.columns - 1; }

  CostMatrix counts;
  std::vector<double> area_size;
  std::vector<double> room_size;
};

void scoreIntersections(const Overlap& overlap, AreaScores& scores) {
  CostMatrix cost{overlap.areas(), overlap.rooms(),
                  std::vector<double>(overlap.areas() * overlap.rooms())};
  for (std::size_t a = 0; a < cost.rows; ++a) {
    for (std::size_t r = 0; r < cost.columns; ++r) {
      const double common = overlap.counts.at(a + 1, r + 1);
      const double either = overlap.area_size[a + 1] + overlap.room_size[r + 1] - common;
      cost.at(a, r) = -common / either;
    }
  }
  double sum = 0;
  double hits = 0;
  for (const auto& [a, r] : assignAtLeastCost(cost)) {
    sum -= cost.at(a, r);
    hits += cost.at(a, r) <= -0.5 ? 1 : 0;
  }
  const auto areas = static_cast<double>(overlap.areas());
  const auto rooms = static_cast<double>(overlap.rooms());
  scores.iou_all = sum / std::max(areas, rooms);
  scores.f1_50 = 2 * hits / (areas + rooms);
}

double matthews(double tp, double fp, double fn, double tn) {
  const double d =
      std::sqrt(tp + fp) * std::sqrt(tp + fn) * std::sqrt(tn + fp) * std::sqrt(tn + fn);
  return d > 0 ? (tp * tn - fp * fn) / d : 0;
}

/// Areas choose their rooms greedily, the one with the largest overlap first.
double scoreCorrelation(const Overlap& overlap) {
  const CostMatrix& counts = overlap.counts;
  const auto bestRoom = [&](std::size_t area, const std::vector<bool>& taken) {
    std::size_t best = 0;
    for (std::size_t r = 1; r < counts.columns; ++r) {
      const double least = best == 0 ? 0 : counts.at(area, best);
      if (!taken[r] && counts.at(area, r) > least) best = r;
    }
    return best;
  };
  std::vector<bool> taken(counts.columns, false);
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t a = 1; a < counts.rows; ++a) {
    order.emplace_back(counts.at(a, bestRoom(a, taken)), a);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& p, const auto& q) { return p.first > q.first; });
  const double pixels = std::accumulate(overlap.area_size.begin() + 1, overlap.area_size.end(), 0.);
  double sum = 0;
  std::size_t count = overlap.rooms();
  for (const auto& [largest, a] : order) {
    const std::size_t r = bestRoom(a, taken);
    if (r == 0) {
      ++count;
      continue;
    }
    taken[r] = true;
    const double tp = counts.at(a, r);
    const double fp = overlap.area_size[a] - tp;
    const double fn = overlap.room_size[r] - tp;
    sum += matthews(tp, fp, fn, pixels - tp - fp - fn);
  }
  return sum / static_cast<double>(count);
}

}  // namespace

AreaScores scoreAreas(const OccupancyMap& map, const std::vector<std::uint16_t>& labels,
                      const std::vector<std::uint16_t>& rooms) {
  checkSize("labels", labels, map);
  checkSize("rooms", rooms, map);
  Labels large_rooms = compact(rooms, kMinPixels);
  for (std::size_t i = 0; i < large_rooms.size(); ++i) {
    if (map.pixels()[i] != Occupancy::kFree) large_rooms[i] = 0;
  }
  large_rooms = compact(std::move(large_rooms), 0);
  const Overlap overlap(compact(labels, kMinPixels), large_rooms);
  AreaScores scores;
  scores.areas = overlap.areas();
  scores.rooms = overlap.rooms();
  if (scores.areas == 0 || scores.rooms == 0) return scores;
  scoreIntersections(overlap, scores);

  Labels both = labels;
  for (std::size_t i = 0; i < both.size(); ++i) {
    if (both[i] == 0 || large_rooms[i] == 0) both[i] = large_rooms[i] = 0;
  }
  const Overlap common(compact(std::move(both), 0), compact(std::move(large_rooms), 0));
  if (common.areas() > 0) scores.mcc = scoreCorrelation(common);
  return scores;
}

DoorScores scoreDoors(const OccupancyMap& map, const std::vector<Segment>& doors_map,
                      const std::vector<std::uint16_t>& rooms, double tolerance) {
  checkSize("rooms", rooms, map);
  const MapGeometry& geometry = map.geometry();
  const auto borders = findRoomBorders(map, compact(rooms, kMinPixels), kMinBorder);
  DoorScores scores;
  scores.doors = doors_map.size();
  scores.borders = borders.size();
  if (doors_map.empty() || borders.empty()) return scores;
  CostMatrix distance{doors_map.size(), borders.size(), {}};
  for (const Segment& door : doors_map) {
    const Point2 middle = inverse(geometry.map_from_image) * door.midpoint() / geometry.resolution;
    for (const Stretch& border : borders) {
      // the cap keeps one far pair from deciding over many near ones
      double nearest = 10 * tolerance;
      for (const BorderPoint& point : border) {
        const double d = (point.position(geometry) - middle).norm() * geometry.resolution;
        nearest = std::min(nearest, d);
      }
      distance.values.push_back(nearest);
    }
  }
  double hits = 0;
  for (const auto& [d, b] : assignAtLeastCost(distance)) {
    hits += distance.at(d, b) <= tolerance ? 1 : 0;
  }
  scores.precision = hits / static_cast<double>(scores.doors);
  scores.recall = hits / static_cast<double>(scores.borders);
  return scores;
}

}  // namespace agrid
