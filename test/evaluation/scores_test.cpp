// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/evaluation/scores.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include <gtest/gtest.h>

#include "support/ascii_map.h"
#include "support/generated_maps.h"

namespace agrid {
namespace {

using Labels = std::vector<std::uint16_t>;

/// A free map of columns of 12 pixels height; one character of `columns` names each one's label.
Labels columnLabels(const std::string& columns) {
  Labels labels;
  for (int y = 0; y < 12; ++y) {
    for (const char c : columns) labels.push_back(static_cast<std::uint16_t>(c - '0'));
  }
  return labels;
}

OccupancyMap freeMap(int width) {
  const std::string row(static_cast<std::size_t>(width), '.');
  return test::asciiMap(std::vector<std::string>(12, row), 0.1);
}

TEST(Scores, PerfectAreasScoreOne) {
  const Labels rooms = columnLabels("111111111111222222222222222");
  const Labels areas = columnLabels("222222222222111111111111111");
  const AreaScores scores = scoreAreas(freeMap(27), areas, rooms);
  EXPECT_DOUBLE_EQ(scores.iou_all, 1);
  EXPECT_DOUBLE_EQ(scores.f1_50, 1);
  EXPECT_DOUBLE_EQ(scores.mcc, 1);
  EXPECT_EQ(scores.areas, 2U);
  EXPECT_EQ(scores.rooms, 2U);
}

TEST(Scores, OneAreaOverTwoRoomsLosesTheSmallerOne) {
  const Labels rooms = columnLabels("11111111111122222222222222222222");
  const Labels areas = columnLabels("11111111111111111111111111111111");
  const AreaScores scores = scoreAreas(freeMap(32), areas, rooms);
  EXPECT_DOUBLE_EQ(scores.iou_all, 20. / 32 / 2);
  EXPECT_DOUBLE_EQ(scores.f1_50, 2. / 3);
  EXPECT_DOUBLE_EQ(scores.mcc, 0);
}

TEST(Scores, SmallAreasAndFurnitureDoNotCount) {
  Labels rooms = columnLabels("1111111111111111");
  Labels areas = columnLabels("1111111111111122");  // area 2 has 24 pixels
  const OccupancyMap map = test::asciiMap(std::vector<std::string>(12, "............####"), 0.1);
  const AreaScores scores = scoreAreas(map, areas, rooms);
  EXPECT_EQ(scores.areas, 1U);
  EXPECT_DOUBLE_EQ(scores.iou_all, 12. / 14);
}

TEST(Scores, RefuseLabelsOfAnotherSize) {
  EXPECT_THROW(scoreAreas(freeMap(4), Labels(3), Labels(48)), std::invalid_argument);
  EXPECT_THROW(scoreDoors(freeMap(4), {}, Labels(3)), std::invalid_argument);
}

TEST(Scores, DoorsAreFoundNearTheBorderOnceEach) {
  const Labels rooms = columnLabels("11111111111122222222222222222222");  // border at x = 1.2 m
  const OccupancyMap map = freeMap(32);
  const Segment on_border{{1.2, 0.2}, {1.2, 1.0}};
  const Segment close{{1.6, 0.2}, {1.6, 1.0}};
  const Segment far{{2.0, 0.2}, {2.0, 1.0}};
  EXPECT_DOUBLE_EQ(scoreDoors(map, {on_border}, rooms).recall, 1);
  EXPECT_DOUBLE_EQ(scoreDoors(map, {close}, rooms).precision, 1);
  EXPECT_DOUBLE_EQ(scoreDoors(map, {on_border, close}, rooms).precision, 0.5);
  EXPECT_DOUBLE_EQ(scoreDoors(map, {far}, rooms).recall, 0);
  EXPECT_DOUBLE_EQ(scoreDoors(map, {}, rooms).precision, 0);
  EXPECT_EQ(scoreDoors(map, {far, close, on_border}, rooms).is_true,
            (std::vector<bool>{false, false, true}));
}

TEST(Scores, DoorsAreFoundNearTrueOnesOnceEach) {
  const Segment truth{{1.2, 0.2}, {1.2, 1.0}};
  const Segment aside{{1.0, 0.6}, {2.4, 0.6}};   // its middle 0.5 m beside
  const Segment beyond{{1.1, 1.6}, {1.3, 1.6}};  // its middle 0.6 m beyond the jamb
  EXPECT_DOUBLE_EQ(scoreDoors({truth}, {truth}).recall, 1);
  EXPECT_DOUBLE_EQ(scoreDoors({aside, truth}, {truth}).precision, 0.5);
  EXPECT_DOUBLE_EQ(scoreDoors({aside}, {truth}, 0.51).precision, 1);
  EXPECT_DOUBLE_EQ(scoreDoors({beyond}, {truth}).recall, 0);
  EXPECT_DOUBLE_EQ(scoreDoors({beyond}, {truth}, 0.61).recall, 1);
  EXPECT_DOUBLE_EQ(scoreDoors({}, {truth}).recall, 0);
  EXPECT_DOUBLE_EQ(scoreDoors({truth}, {}).precision, 0);
  EXPECT_EQ(scoreDoors({aside, beyond, truth}, {truth}).is_true,
            (std::vector<bool>{false, false, true}));
  EXPECT_EQ(scoreDoors({aside, truth}, {}).is_true, std::vector<bool>(2));
}

TEST(Scores, RecallAndPrecisionAreMeansOverRoomsAndAreas) {
  //                                     32 columns of 12 pixels
  const Labels rooms = columnLabels("11111111111122222222222222222222");
  const Labels areas = columnLabels("11111111111111111111003333333333");
  const AreaScores scores = scoreAreas(freeMap(32), areas, rooms);
  EXPECT_DOUBLE_EQ(scores.recall, (1 + 10. / 20) / 2);
  EXPECT_DOUBLE_EQ(scores.precision, (12. / 20 + 1) / 2);
  EXPECT_DOUBLE_EQ(scores.recall_free, scores.recall);
  EXPECT_DOUBLE_EQ(scores.precision_free, scores.precision);
  EXPECT_DOUBLE_EQ(scores.iou_rooms, scores.iou_all);
}

TEST(Scores, FurnitureCountsWhereTheRoomIsTakenWhole) {
  const Labels rooms = columnLabels("1111111111111111");
  const Labels areas = columnLabels("1111111111110000");
  const OccupancyMap map = test::asciiMap(std::vector<std::string>(12, "............####"), 0.1);
  const AreaScores free = scoreAreas(map, areas, rooms);
  EXPECT_DOUBLE_EQ(free.recall, 0.75);
  EXPECT_DOUBLE_EQ(free.recall_free, 1);
  EXPECT_DOUBLE_EQ(free.iou_all, 1);
  const AreaScores whole = scoreAreas(map, areas, rooms, RoomFloor::kAll);
  EXPECT_DOUBLE_EQ(whole.recall_free, 1);
  EXPECT_DOUBLE_EQ(whole.iou_all, 0.75);
}

TEST(Scores, RoomsCutUpAndMergedAreCounted) {
  const Labels rooms = columnLabels("1111111111111111111111222222222222");
  const Labels halves = columnLabels("1111111111133333333333222222222222");
  const Labels all = columnLabels("1111111111111111111111111111111111");
  EXPECT_EQ(scoreAreas(freeMap(34), rooms, rooms).over_segmented, 0U);
  EXPECT_EQ(scoreAreas(freeMap(34), halves, rooms).over_segmented, 1U);
  EXPECT_EQ(scoreAreas(freeMap(34), halves, rooms).under_segmented, 0U);
  EXPECT_EQ(scoreAreas(freeMap(34), all, rooms).over_segmented, 0U);
  EXPECT_EQ(scoreAreas(freeMap(34), all, rooms).under_segmented, 1U);
}

/// Areas or rooms as random rectangles, later ones over earlier ones.
Labels randomLabels(std::mt19937& random, int side) {
  Labels labels(static_cast<std::size_t>(side * side), 0);
  const int count = 2 + static_cast<int>(random() % 4);
  for (int label = 1; label <= count; ++label) {
    const int x = static_cast<int>(random() % 40);
    const int y = static_cast<int>(random() % 40);
    const int width = 8 + static_cast<int>(random() % 30);
    for (int i = 0; i < side * side; ++i) {
      const bool inside =
          i % side >= x && i % side < x + width && i / side >= y && i / side < y + width;
      if (inside) labels[static_cast<std::size_t>(i)] = static_cast<std::uint16_t>(7 * label);
    }
  }
  return labels;
}

double countWhere(const Labels& areas, const Labels& rooms,
                  const std::function<bool(int, int)>& holds) {
  double count = 0;
  for (std::size_t i = 0; i < areas.size(); ++i) count += holds(areas[i], rooms[i]) ? 1 : 0;
  return count;
}

/// The labels of more than 100 pixels.
std::vector<int> largeLabels(const Labels& labels) {
  std::vector<int> large;
  for (int label = 7; label <= 42; label += 7) {
    const auto count = std::count(labels.begin(), labels.end(), label);
    if (count > 100) large.push_back(label);
  }
  return large;
}

TEST(Scores, AgreeWithTheirDefinitionsOnRandomRectangles) {
  std::mt19937 random(11);
  constexpr int kSide = 64;
  const OccupancyMap map(test::uniform(kSide, kSide, 0));
  for (int trial = 0; trial < 40; ++trial) {
    const Labels areas = randomLabels(random, kSide);
    const Labels rooms = randomLabels(random, kSide);
    const std::vector<int> a = largeLabels(areas);
    const std::vector<int> r = largeLabels(rooms);
    if (a.empty() || r.empty()) continue;
    const auto common = [&](int area, int room) {
      return countWhere(areas, rooms, [=](int p, int q) { return p == area && q == room; });
    };
    double recall = 0;
    for (const int room : r) {
      double best = 0;
      for (const int area : a) best = std::max(best, common(area, room));
      recall += best / static_cast<double>(std::count(rooms.begin(), rooms.end(), room));
    }
    double precision = 0;
    for (const int area : a) {
      double best = 0;
      for (const int room : r) best = std::max(best, common(area, room));
      precision += best / static_cast<double>(std::count(areas.begin(), areas.end(), area));
    }
    // Each way to pair them: rooms in every order beside the areas, with gaps.
    std::vector<int> order = r;
    order.resize(r.size() + a.size(), -1);
    std::sort(order.begin(), order.end());
    double best_sum = 0;
    do {
      double sum = 0;
      for (std::size_t i = 0; i < a.size(); ++i) {
        if (order[i] < 0) continue;
        sum += common(a[i], order[i]) /
               countWhere(areas, rooms, [&](int p, int q) { return p == a[i] || q == order[i]; });
      }
      best_sum = std::max(best_sum, sum);
    } while (std::next_permutation(order.begin(), order.end()));
    const AreaScores scores = scoreAreas(map, areas, rooms);
    EXPECT_NEAR(scores.recall, recall / static_cast<double>(r.size()), 1e-12);
    EXPECT_NEAR(scores.precision, precision / static_cast<double>(a.size()), 1e-12);
    EXPECT_NEAR(scores.iou_rooms, best_sum / static_cast<double>(r.size()), 1e-12);
    EXPECT_NEAR(scores.iou_all, best_sum / static_cast<double>(std::max(a.size(), r.size())),
                1e-12);
  }
}

}  // namespace
}  // namespace agrid
