// SPDX-License-Identifier: BSD-3-Clause
#include <random>

#include <gtest/gtest.h>

#include "planning/drawn_costmap.h"

namespace agrid {
namespace {

using test::costmap;
using test::expectFree;
using test::Rows;
using Status = FollowedPath::Status;

/// By the pixels' sides, from the start whatever it is.
bool connected(const Costmap& map, const CostRules& rules, Pixel start, Pixel goal) {
  const planning::CostField field(map, rules, start);
  std::vector<bool> seen(map.costs.size());
  std::vector<Pixel> open{start};
  while (!open.empty()) {
    const Pixel p = open.back();
    open.pop_back();
    if (!map.geometry.contains(p)) continue;
    const std::size_t i = map.geometry.index(p);
    if (seen[i] || field.isBlocked(i)) continue;
    seen[i] = true;
    for (const Pixel step : {Pixel{1, 0}, Pixel{-1, 0}, Pixel{0, 1}, Pixel{0, -1}}) {
      open.push_back({p.x + step.x, p.y + step.y});
    }
  }
  return seen[map.geometry.index(goal)];
}

TEST(LeadFollower, OnRandomCostmapsThereIsAFreePathExactlyWhereAFloodFillConnects) {
  int found = 0;
  int none = 0;
  LeadFollower follower({});  // one for all: what it keeps from one request must not matter
  for (std::uint32_t seed = 1; seed <= 300; ++seed) {
    std::mt19937 random(seed);
    const auto pick = [&](int count) {
      return static_cast<int>(random() % static_cast<std::uint32_t>(count));
    };
    Rows rows(static_cast<std::size_t>(10 + pick(40)),
              std::string(static_cast<std::size_t>(10 + pick(40)), '.'));
    const int walls = 5 + pick(30);
    for (std::string& row : rows) {
      for (char& c : row) c = pick(100) < walls ? '#' : "..5?i"[pick(5)];
    }
    const Costmap map = costmap(rows);
    const auto pixel = [&] { return Pixel{pick(map.geometry.width), pick(map.geometry.height)}; };
    const Pixel start = pixel();
    const Pixel goal = pixel();
    if (map.costs[map.geometry.index(goal)] >= kInscribed) continue;
    const Segment ends{map.geometry.center(start), map.geometry.center(goal)};
    const std::vector<Point2> way{ends.a, map.geometry.center(pixel()), ends.b};
    const LeadSource leads = [&](const std::vector<DoorId>& closed) {
      return Lead{closed.size() < 3,
                  way,
                  {{DoorId{static_cast<std::uint32_t>(closed.size() + 1)}, {way[1], way[0]}}},
                  ""};
    };
    const FollowedPath path = follower.plan(map, ends, 0, leads);
    SCOPED_TRACE("seed " + std::to_string(seed));
    ASSERT_EQ(path.status == Status::kFound, connected(map, {}, start, goal));
    if (path.status == Status::kFound) expectFree(map, path, ends);
    (path.status == Status::kFound ? found : none)++;
  }
  EXPECT_GT(found, 40);
  EXPECT_GT(none, 40);
}

}  // namespace
}  // namespace agrid
