// SPDX-License-Identifier: BSD-3-Clause
#include "planning/portal_search.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

#include "planning/landmarks.h"
#include "planning/sample_roads.h"

namespace agrid::planning {
namespace {

using test::RoadSample;

/// Float sums over some dozen portals.
constexpr float kRounding = 2e-3F;

/// Portals crossed to either side, numbered as 2 * portal + side: relaxed until nothing changes.
void relaxAll(const RoadSample& s, Measure measure, std::vector<float>& lengths) {
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t state = 0; state < lengths.size(); ++state) {
      if (lengths[state] == kUnreachable) continue;
      const std::uint32_t region = s.regions().portals()[state / 2].nodes[state % 2];
      const auto visit = [&](std::uint32_t other, float length) {
        const std::size_t beyond = 1 - s.regions().portals()[other].sideOf(region);
        float& known = lengths[2 * other + beyond];
        if (!(lengths[state] + length < known)) return;
        known = lengths[state] + length;
        changed = true;
      };
      s.roadmap().forEachOnwards(measure, state / 2, state % 2, visit);
    }
  }
}

std::vector<float> lengthsFrom(const RoadSample& s, Measure measure, RoadEnd& start) {
  std::vector<float> lengths(2 * s.regions().portals().size(), kUnreachable);
  std::size_t rank = 0;
  for (const std::uint32_t portal : s.regions().portalsOf(start.region())) {
    const std::size_t beyond = 1 - s.regions().portals()[portal].sideOf(start.region());
    lengths[2 * portal + beyond] = start.length(measure, rank++);
  }
  relaxAll(s, measure, lengths);
  return lengths;
}

const Landmarks& landmarksOf(const RoadSample& s, Measure measure) {
  return measure == Measure::kPath ? s.level->path_landmarks : s.level->least_landmarks;
}

TEST(Landmarks, BoundTheWaysBetweenPortalsFromBelow) {
  std::mt19937 random(54);
  int compared = 0;
  double gap = 0;
  for (int trial = 0; trial < 120; ++trial) {
    const RoadSample s = test::randomRoadSample(random);
    const std::size_t count = s.regions().portals().size();
    for (const Measure measure : {Measure::kPath, Measure::kLeast}) {
      const Landmarks& landmarks = landmarksOf(s, measure);
      for (int i = 0; i < 5 && count > 0; ++i) {
        const auto from = static_cast<std::uint32_t>(random() % count);
        std::vector<float> lengths(2 * count, kUnreachable);
        lengths[2 * from] = lengths[2 * from + 1] = 0;
        relaxAll(s, measure, lengths);
        for (std::uint32_t to = 0; to < count; ++to) {
          const float length = std::min(lengths[2 * to], lengths[2 * to + 1]);
          if (length == kUnreachable) continue;
          float bound = 0;
          for (std::size_t k = 0; k < Landmarks::kCount; ++k) {
            bound = std::max(bound, std::abs(landmarks.of(from).to[k] - landmarks.of(to).to[k]));
          }
          ASSERT_LE(bound, length + kRounding) << "trial " << trial;
          gap += length == 0 ? 0 : 1 - bound / length;
          ++compared;
        }
      }
    }
  }
  ASSERT_GT(compared, 3000);
  EXPECT_LT(gap / compared, 0.25);
}

/// A search between two random ends; `pick` for a point, else for an area.
struct Question {
  Target target;
  std::unique_ptr<RoadEnd> start;
  std::unique_ptr<RoadEnd> goal;
};

std::optional<Question> randomQuestion(std::mt19937& random, const RoadSample& s) {
  const std::vector<Pixel> pixels = s.freePixels();
  if (pixels.empty()) return std::nullopt;
  const Pixel p = pixels[random() % pixels.size()];
  const Pixel q = pixels[random() % pixels.size()];
  Question question;
  question.start = std::make_unique<RoadEnd>(s.free(), s.roadmap(), centerOf(p), s.regionAt(p));
  const std::uint32_t region = s.regionAt(q);
  if (random() % 2 == 0) {
    question.goal = std::make_unique<RoadEnd>(s.free(), s.roadmap(), centerOf(q), region);
    question.target.point = centerOf(q);
    question.target.regions = {region};
    question.target.box.add(q);
    return question;
  }
  question.target.label = s.level->regionLabels().labelOf(region);
  for (std::uint32_t i = 0; i < s.regions().nodeCount(); ++i) {
    const bool is_reached =
        s.regions().componentOf(i) == s.regions().componentOf(question.start->region());
    if (is_reached && s.level->regionLabels().labelOf(i) == question.target.label) {
      question.target.regions.push_back(i);
    }
  }
  for (const Pixel pixel : pixels) {
    if (s.level->regionLabels().labelOf(s.regionAt(pixel)) == question.target.label) {
      question.target.box.add(pixel);
    }
  }
  if (s.level->regionLabels().labelOf(s.regionAt(p)) == question.target.label) return std::nullopt;
  return question;
}

float shortest(const RoadSample& s, Measure measure, Question& question) {
  const std::vector<float> lengths = lengthsFrom(s, measure, *question.start);
  float best = kUnreachable;
  for (const std::uint32_t region : question.target.regions) {
    std::size_t rank = 0;
    for (const std::uint32_t portal : s.regions().portalsOf(region)) {
      const std::size_t side = s.regions().portals()[portal].sideOf(region);
      const float leg = question.goal ? question.goal->length(measure, rank) : 0.0F;
      best = std::min(best, lengths[2 * portal + side] + leg);
      ++rank;
    }
  }
  return best;
}

float lengthOfWay(const RoadSample& s, Measure measure, Question& question,
                  const std::vector<Crossing>& way) {
  const auto rankLeaving = [&](const Crossing& c) {
    return s.roadmap().rankOf(c.portal, 1 - c.side);
  };
  float sum = question.start->length(measure, rankLeaving(way.front()));
  for (std::size_t i = 1; i < way.size(); ++i) {
    const std::uint32_t region = s.regions().portals()[way[i - 1].portal].nodes[way[i - 1].side];
    const RegionRoads& roads = s.roadmap().roads(region);
    const std::size_t from = s.roadmap().rankOf(way[i - 1].portal, way[i - 1].side);
    sum += roads.lengthsTo(measure, from)[roads.points().size() + rankLeaving(way[i])];
  }
  const Crossing& last = way.back();
  if (!question.goal) return sum;
  return sum + question.goal->length(measure, s.roadmap().rankOf(last.portal, last.side));
}

TEST(PortalSearch, FindsTheShortestWayOfAll) {
  std::mt19937 random(55);
  int found = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    const RoadSample s = test::randomRoadSample(random);
    for (const Measure measure : {Measure::kPath, Measure::kLeast}) {
      std::optional<Question> question = randomQuestion(random, s);
      if (!question) continue;
      const float expected = shortest(s, measure, *question);
      // Ends that have been looked from before must not matter.
      RoadEnd fresh(s.free(), s.roadmap(), question->start->point(), question->start->region());
      RoadGoal goal(*s.level, question->target);
      PortalSearch search(s.roadmap(), measure, landmarksOf(s, measure), goal);
      const float length = search.find(fresh, kUnreachable, {});
      ASSERT_EQ(length == kUnreachable, expected == kUnreachable);
      ASSERT_EQ(search.way().empty(), expected == kUnreachable);
      if (length == kUnreachable) continue;
      // Least lengths may undercut the straight line, which the search knows as well.
      ASSERT_GE(length, expected - kRounding);
      if (measure == Measure::kPath) {
        ASSERT_NEAR(length, expected, kRounding);
      }
      ASSERT_NEAR(lengthOfWay(s, measure, *question, search.way()), length, kRounding);
      ++found;
      const float limit = length / 2;
      EXPECT_EQ(search.find(fresh, limit, {}), limit);
      EXPECT_TRUE(limit == 0 || search.way().empty());
    }
  }
  EXPECT_GT(found, 300);
}

}  // namespace
}  // namespace agrid::planning
