// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "agrid/evaluation/scores.h"
#include "areas/assignment.h"
#include "evaluation/label_overlap.h"

namespace agrid {
namespace {

struct RecallPrecision {
  double recall = 0;
  double precision = 0;
};

/// Bormann et al. 2016, the mean over rooms and over areas (their 'micro').
RecallPrecision bestShares(const LabelOverlap& overlap) {
  std::vector<double> best_area(overlap.room_size.size(), 0);
  RecallPrecision mean;
  if (overlap.areas() == 0 || overlap.rooms() == 0) return mean;
  for (std::size_t a = 1; a <= overlap.areas(); ++a) {
    double best_room = 0;
    for (const auto& [room, pixels] : overlap.of_area[a]) {
      best_room = std::max(best_room, pixels);
      best_area[room] = std::max(best_area[room], pixels);
    }
    mean.precision += best_room / overlap.area_size[a];
  }
  for (std::size_t r = 1; r <= overlap.rooms(); ++r) {
    mean.recall += best_area[r] / overlap.room_size[r];
  }
  mean.precision /= static_cast<double>(overlap.areas());
  mean.recall /= static_cast<double>(overlap.rooms());
  return mean;
}

void scoreIntersections(const LabelOverlap& overlap, AreaScores& scores) {
  std::vector<PairValue> candidates;
  for (std::size_t a = 1; a <= overlap.areas(); ++a) {
    for (const auto& [room, pixels] : overlap.of_area[a]) {
      const double either = overlap.area_size[a] + overlap.room_size[room] - pixels;
      candidates.push_back({a, room, pixels / either});
    }
  }
  double sum = 0;
  double hits = 0;
  for (const PairValue& pair : assignAtMostValue(candidates)) {
    sum += pair.value;
    hits += pair.value >= 0.5 ? 1 : 0;
  }
  const auto areas = static_cast<double>(overlap.areas());
  const auto rooms = static_cast<double>(overlap.rooms());
  scores.iou_all = sum / std::max(areas, rooms);
  scores.iou_rooms = sum / rooms;
  scores.f1_50 = 2 * hits / (areas + rooms);
}

void countSplits(const LabelOverlap& overlap, AreaScores& scores) {
  std::vector<int> parts(overlap.room_size.size(), 0);
  for (std::size_t a = 1; a <= overlap.areas(); ++a) {
    double inside = 0;
    for (const auto& [room, pixels] : overlap.of_area[a]) inside += pixels;
    int held = 0;
    for (const auto& [room, pixels] : overlap.of_area[a]) {
      held += pixels > 0.5 * overlap.room_size[room] ? 1 : 0;
      const bool part = pixels > 0.5 * inside && pixels >= 0.1 * overlap.room_size[room];
      parts[room] += part ? 1 : 0;
    }
    scores.under_segmented += held >= 2 ? 1 : 0;
  }
  scores.over_segmented = static_cast<std::size_t>(
      std::count_if(parts.begin(), parts.end(), [](int n) { return n >= 2; }));
}

double matthews(double tp, double fp, double fn, double tn) {
  const double d =
      std::sqrt(tp + fp) * std::sqrt(tp + fn) * std::sqrt(tn + fp) * std::sqrt(tn + fn);
  return d > 0 ? (tp * tn - fp * fn) / d : 0;
}

/// Areas choose their rooms greedily, the one with the largest overlap first.
double scoreCorrelation(const LabelOverlap& overlap) {
  std::vector<bool> taken(overlap.room_size.size(), false);
  const auto bestRoom = [&](std::size_t area) {
    LabelOverlap::Common best;
    for (const auto& common : overlap.of_area[area]) {
      if (!taken[common.room] && common.pixels > best.pixels) best = common;
    }
    return best;
  };
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t a = 1; a <= overlap.areas(); ++a) order.emplace_back(bestRoom(a).pixels, a);
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& p, const auto& q) { return p.first > q.first; });
  const double all = std::accumulate(overlap.area_size.begin() + 1, overlap.area_size.end(), 0.);
  double sum = 0;
  std::size_t count = overlap.rooms();
  for (const auto& [largest, a] : order) {
    const auto [room, tp] = bestRoom(a);
    if (room == 0) {
      ++count;
      continue;
    }
    taken[room] = true;
    const double fp = overlap.area_size[a] - tp;
    const double fn = overlap.room_size[room] - tp;
    sum += matthews(tp, fp, fn, all - tp - fp - fn);
  }
  return sum / static_cast<double>(count);
}

double correlationWhereBothAre(Labels areas, Labels rooms) {
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (areas[i] == 0 || rooms[i] == 0) areas[i] = rooms[i] = 0;
  }
  const LabelOverlap common(compact(std::move(areas), 0), compact(std::move(rooms), 0));
  return common.areas() > 0 ? scoreCorrelation(common) : 0;
}

}  // namespace

AreaScores scoreAreas(const OccupancyMap& map, const std::vector<std::uint16_t>& labels,
                      const std::vector<std::uint16_t>& rooms, RoomFloor floor) {
  checkSize("labels", labels, map);
  checkSize("rooms", rooms, map);
  const Labels areas = compact(labels, kMinLabelPixels);
  Labels large_rooms = compact(rooms, kMinLabelPixels);
  AreaScores scores;
  const RecallPrecision whole = bestShares(LabelOverlap(areas, large_rooms));
  scores.recall = whole.recall;
  scores.precision = whole.precision;
  const RecallPrecision free =
      bestShares(LabelOverlap(compact(onFreePixels(labels, map), kMinLabelPixels),
                              compact(onFreePixels(rooms, map), kMinLabelPixels)));
  scores.recall_free = free.recall;
  scores.precision_free = free.precision;
  if (floor == RoomFloor::kFree) {
    large_rooms = compact(onFreePixels(std::move(large_rooms), map), 0);
  }
  const LabelOverlap overlap(areas, large_rooms);
  scores.areas = overlap.areas();
  scores.rooms = overlap.rooms();
  if (scores.areas == 0 || scores.rooms == 0) return scores;
  scoreIntersections(overlap, scores);
  countSplits(overlap, scores);
  scores.mcc = correlationWhereBothAre(labels, std::move(large_rooms));
  return scores;
}

}  // namespace agrid
