// SPDX-License-Identifier: BSD-3-Clause
#include "planning/figures.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <numeric>
#include <random>

#include <malloc.h>

#include "agrid/map/map_io.h"
#include "agrid/pipeline.h"
#include "agrid/planning/planner.h"
#include "planning/clock.h"
#include "planning/pixel_a_star.h"
#include "planning/reference.h"
#include "tools/image_frame.h"

namespace agrid::bench {
namespace {

constexpr int kRepetitions = 3;
constexpr int kWarmUpPairs = 20;
constexpr int kSeparatedPairs = 20;
constexpr std::size_t kDoors = 25;
constexpr std::size_t kFewestCompared = 10;
constexpr std::uint32_t kSeed = 7;

/// Bytes that the program holds from malloc, in all arenas and in mappings of its own; operator new
/// and cv::Mat take theirs there.
double heldBytes() {
  malloc_trim(0);
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

void say(const Subject& subject, const char* what) {
  std::fprintf(stderr, "%s: %s\n", subject.name.c_str(), what);
}

/// The resolution comes in single precision: 0.2 m at 0.05 m a pixel are 4 pixels, no hair less.
double radiusPx(double radius, const MapGeometry& geometry) {
  return std::round(radius / geometry.resolution * 1e6) / 1e6;
}

PlanRequest requestOf(const tools::Pair& pair, const MapGeometry& geometry) {
  PlanRequest request;
  request.start.position_map = tools::mapPoint(pair.start_px, geometry);
  PlanPoint goal;
  goal.position_map = tools::mapPoint(pair.goal_px, geometry);
  request.goal = goal;
  return request;
}

struct Answer {
  Plan plan;
  double seconds = std::numeric_limits<double>::max();  ///< the shortest of some times
};

Answer ask(const Planner& planner, const PlanRequest& request) {
  Answer answer;
  for (int i = 0; i < kRepetitions; ++i) {
    const double seconds = secondsOf([&] { answer.plan = planner.plan(request); });
    answer.seconds = std::min(answer.seconds, seconds);
  }
  return answer;
}

/// Whether a path starts, ends and measures as it should and touches free pixels only.
bool holds(const Plan& plan, const tools::Pair& pair, const Ground& ground,
           const MapGeometry& geometry) {
  constexpr double tolerance = 1e-3;  // px
  std::vector<Point2> corners;
  for (const Pose2& pose : plan.path_map) {
    corners.push_back(tools::imagePoint(pose.position, geometry));
  }
  if (corners.empty()) return false;
  double length = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point2& from = corners[i == 0 ? 0 : i - 1];
    length += (corners[i] - from).norm();
    if (!segmentIsFree(ground, from, corners[i])) return false;
  }
  return (corners.front() - pair.start_px).norm() < tolerance &&
         (corners.back() - pair.goal_px).norm() < tolerance &&
         std::abs(length - plan.length / geometry.resolution) < tolerance;
}

/// One map, being measured.
class Session {
 public:
  Session(const Subject& subject, const Effort& effort) : subject_(subject), effort_(effort) {
    MapFileParams file_params;
    file_params.skip_opaque_alpha = true;  // the pairs go by the colours of the picture
    const auto map = std::make_shared<const OccupancyMap>(loadMap(subject.yaml, file_params).grid);
    geometry_ = map->geometry();
    say(subject_, "flood fill");
    ground_ = readGround(subject.image, radiusPx(effort.robot_radius, geometry_));
    say(subject_, "areas and doors");
    map_ = std::make_shared<const SemanticMap>(annotate(extractStructure(map, {}), {}, {}));
    figures_.map = subject.name;
    figures_.megapixels = static_cast<double>(geometry_.pixelCount()) / 1e6;
  }

  Figures run() {
    params_.robot_radius = effort_.robot_radius;
    params_.timeout = 60;
    build();
    readPairs();
    say(subject_, "queries and distance transforms");
    timeTransform();
    answerPairs();
    timeTransform();
    answerSeparatedPairs();
    figures_.bytes = heldBytes() - bytes_before_;
    timeTransform();
    say(subject_, "doors");
    switchDoors();
    planner_.reset();
    say(subject_, "pixel A* and reference lengths");
    compare();
    return figures_;
  }

 private:
  void build() {
    say(subject_, "planner");
    bytes_before_ = heldBytes();
    figures_.build_seconds =
        secondsOf([&] { planner_ = std::make_unique<Planner>(map_, params_); });
  }

  /// Other programs come and go: not all at one moment.
  void timeTransform() {
    const std::vector<double> seconds = transformSeconds(subject_.image);
    figures_.transform_seconds.insert(figures_.transform_seconds.end(), seconds.begin(),
                                      seconds.end());
  }

  void readPairs() {
    figures_.best_known = !subject_.pairs.empty();
    pairs_ = figures_.best_known ? tools::readPairs(subject_.pairs)
                                 : drawPairs(ground_, effort_.drawn_pairs, kSeed);
    figures_.pairs = pairs_.size();
    for (std::size_t i = 0; i < std::min<std::size_t>(kWarmUpPairs, pairs_.size()); ++i) {
      planner_->plan(requestOf(pairs_[i], geometry_));
    }
  }

  void answerPairs() {
    for (const tools::Pair& pair : pairs_) {
      const Answer answer = ask(*planner_, requestOf(pair, geometry_));
      answers_.push_back({0, 0});
      if (judge(pair, answer)) answers_.back() = {answer.plan.length, answer.seconds};
    }
  }

  /// Counts an answer; true if it is a path where there is one.
  bool judge(const tools::Pair& pair, const Answer& answer) {
    const bool connected = ground_.connects(pair.start_px, pair.goal_px);
    const bool found = answer.plan.status == PlanStatus::kSuccess;
    figures_.false_no += connected && !found ? 1U : 0U;
    figures_.false_found += !connected && found ? 1U : 0U;
    if (answer.plan.status == PlanStatus::kNoRoute) {
      figures_.no_path_seconds.push_back(answer.seconds);
    }
    if (!connected || !found) return false;
    figures_.not_free += holds(answer.plan, pair, ground_, geometry_) ? 0U : 1U;
    figures_.query_seconds.push_back(answer.seconds);
    if (answer.plan.length_bound > 0) {
      figures_.bound_gaps.push_back(answer.plan.length / answer.plan.length_bound - 1);
    }
    if (pair.best_known_px && *pair.best_known_px > 0) {
      figures_.length_ratios.push_back(answer.plan.length / geometry_.resolution /
                                       *pair.best_known_px);
    }
    return true;
  }

  void answerSeparatedPairs() {
    for (const tools::Pair& pair : drawSeparatedPairs(ground_, kSeparatedPairs, kSeed)) {
      judge(pair, ask(*planner_, requestOf(pair, geometry_)));
    }
  }

  /// Closes doors between two areas and opens them again: whatever a user of the library has to do
  /// for it, and the first plan from one side to the other.
  void switchDoors() {
    SemanticMap now = *map_;
    std::vector<std::size_t> doors;
    for (std::size_t i = 0; i < now.area_map.doors.size(); ++i) {
      const auto& sides = now.area_map.doors[i].areas;
      if (sides[0] != AreaId{0} && sides[1] != AreaId{0}) doors.push_back(i);
    }
    const std::size_t step = std::max<std::size_t>(1, doors.size() / kDoors);
    for (std::size_t i = 0; i < doors.size(); i += step) {
      for (const DoorState state : {DoorState::kClosed, DoorState::kOpen}) {
        now.area_map.doors[doors[i]].state = state;
        switchTo(std::make_shared<const SemanticMap>(now), now.area_map.doors[doors[i]]);
      }
    }
  }

  void switchTo(const std::shared_ptr<const SemanticMap>& map, const Door& door) {
    figures_.door_seconds.push_back(
        secondsOf([&] { planner_ = std::make_unique<Planner>(map, *planner_); }));
    PlanRequest request;
    request.start.position_map = findArea(*map, door.areas[0])->anchor_map;
    PlanPoint goal;
    goal.position_map = findArea(*map, door.areas[1])->anchor_map;
    request.goal = goal;
    request.tolerance = 1;
    const double first = secondsOf([&] { planner_->plan(request); });
    figures_.first_plan_seconds.push_back(first + figures_.door_seconds.back());
  }

  /// A* and reference lengths on pairs in random order until the time is over.
  void compare() {
    PixelAStar a_star(ground_);
    std::unique_ptr<Reference> reference;
    if (!figures_.best_known) reference = std::make_unique<Reference>(ground_, a_star);
    double spent = 0;
    for (const std::size_t i : shuffledPairs()) {
      if (answers_[i].seconds == 0) continue;
      if (spent > effort_.reference_seconds && figures_.a_star_seconds.size() >= kFewestCompared) {
        break;
      }
      spent += secondsOf([&] { comparePair(i, a_star, reference.get()); });
    }
  }

  void comparePair(std::size_t i, PixelAStar& a_star, Reference* reference) {
    const auto pixelOf = [&](const Point2& p) {
      return ground_.index(static_cast<int>(std::lround(p.x())),
                           static_cast<int>(std::lround(p.y())));
    };
    const std::size_t start = pixelOf(pairs_[i].start_px);
    const std::size_t goal = pixelOf(pairs_[i].goal_px);
    double best = std::numeric_limits<double>::max();
    for (int k = 0; k < kRepetitions; ++k) {
      best = std::min(best, secondsOf([&] { a_star.search(start, goal); }));
    }
    figures_.a_star_seconds.push_back(best);
    figures_.compared_query_seconds.push_back(answers_[i].seconds);
    if (reference == nullptr) return;
    const double length = reference->length(start, goal);
    if (length > 0) {
      figures_.length_ratios.push_back(answers_[i].length / geometry_.resolution / length);
    }
  }

  std::vector<std::size_t> shuffledPairs() const {
    std::vector<std::size_t> order(pairs_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::mt19937 random(kSeed);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    return order;
  }

  struct Found {
    double length;   ///< [m]
    double seconds;  ///< 0: no path
  };

  const Subject& subject_;
  const Effort& effort_;
  MapGeometry geometry_;
  Ground ground_;
  std::shared_ptr<const SemanticMap> map_;
  PlannerParams params_;
  std::unique_ptr<Planner> planner_;
  std::vector<tools::Pair> pairs_;
  std::vector<Found> answers_;  ///< as pairs_
  Figures figures_;
  double bytes_before_ = 0;
};

}  // namespace

Figures measure(const Subject& subject, const Effort& effort) {
  return Session(subject, effort).run();
}

}  // namespace agrid::bench
