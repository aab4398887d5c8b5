// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "agrid/evaluation/scores.h"
#include "evaluation/label_overlap.h"

namespace agrid {
namespace {

struct RecallPrecision {
  double recall = 0;
  double precision = 0;
};

/// Bormann et al. 2016, the mean over rooms and over areas (their 'micro').
RecallPrecision bestShares(const LabelOverlap& overlap) {
  const CostMatrix& counts = overlap.counts;
  std::vector<double> best_area(counts.columns, 0);
  RecallPrecision mean;
  if (overlap.areas() == 0 || overlap.rooms() == 0) return mean;
  for (std::size_t a = 1; a < counts.rows; ++a) {
    double best_room = 0;
    for (std::size_t r = 1; r < counts.columns; ++r) {
      best_room = std::max(best_room, counts.at(a, r));
      best_area[r] = std::max(best_area[r], counts.at(a, r));
    }
    mean.precision += best_room / overlap.area_size[a];
  }
  for (std::size_t r = 1; r < counts.columns; ++r) {
    mean.recall += best_area[r] / overlap.room_size[r];
  }
  mean.precision /= static_cast<double>(overlap.areas());
  mean.recall /= static_cast<double>(overlap.rooms());
  return mean;
}

void scoreIntersections(const LabelOverlap& overlap, AreaScores& scores) {
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
  scores.iou_rooms = sum / rooms;
  scores.f1_50 = 2 * hits / (areas + rooms);
}

void countSplits(const LabelOverlap& overlap, AreaScores& scores) {
  const CostMatrix& counts = overlap.counts;
  std::vector<int> parts(counts.columns, 0);
  for (std::size_t a = 1; a < counts.rows; ++a) {
    const double inside = overlap.area_size[a] - counts.at(a, 0);
    int held = 0;
    for (std::size_t r = 1; r < counts.columns; ++r) {
      const double common = counts.at(a, r);
      held += common > 0.5 * overlap.room_size[r] ? 1 : 0;
      const bool part = common > 0.5 * inside && common >= 0.1 * overlap.room_size[r];
      parts[r] += part ? 1 : 0;
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
