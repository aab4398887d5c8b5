// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/exact_space.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <mutex>
#include <utility>

#include <ompl/base/ProjectionEvaluator.h>
#include <ompl/base/spaces/RealVectorStateSpace.h>
#include <ompl/util/Console.h>

#include "planning/ompl/last_valid.h"

namespace agrid::planning {
namespace {

namespace ob = ompl::base;
using PlaneState = ob::RealVectorStateSpace::StateType;

class FreePixels : public ob::StateValidityChecker {
 public:
  FreePixels(const ob::SpaceInformationPtr& space, const FreeSpace& free)
      : ob::StateValidityChecker(space), free_(free) {}
  bool isValid(const ob::State* state) const override {
    const FinePoint p = finePointOf(state);
    return free_.canSee(p, p);
  }

 private:
  const FreeSpace& free_;
};

class LineOfSight : public ob::MotionValidator {
 public:
  LineOfSight(const ob::SpaceInformationPtr& space, const FreeSpace& free)
      : ob::MotionValidator(space), free_(free) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    return free_.canSee(finePointOf(a), finePointOf(b));
  }

  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(a, b)) return true;
    const auto is_free = [&](const ob::State* middle) { return checkMotion(a, middle); };
    findLastValid(si_->getStateSpace(), a, b, is_free, last_valid);
    return false;
  }

 private:
  const FreeSpace& free_;
};

class GuidedSampler : public ob::StateSampler {
 public:
  GuidedSampler(const ob::StateSpace* space, const std::vector<PixelBox>& boxes, std::uint32_t seed)
      : ob::StateSampler(space), boxes_(boxes) {
    rng_.setLocalSeed(seed);
    for (const PixelBox& box : boxes) {
      total_ += static_cast<double>(box.columns() * box.rows());
      sums_.push_back(total_);
    }
  }

  void sampleUniform(ob::State* state) override {
    const auto& bounds = space_->as<ob::RealVectorStateSpace>()->getBounds();
    auto* values = state->as<PlaneState>()->values;
    if (boxes_.empty() || rng_.uniform01() < kUnguidedShare) {
      for (unsigned i = 0; i < 2; ++i) values[i] = rng_.uniformReal(bounds.low[i], bounds.high[i]);
      return;
    }
    const auto chosen = std::upper_bound(sums_.begin(), sums_.end() - 1, total_ * rng_.uniform01());
    const PixelBox& box = boxes_[static_cast<std::size_t>(chosen - sums_.begin())];
    values[0] = rng_.uniformReal(box.low.x - 0.5, box.high.x + 0.5);
    values[1] = rng_.uniformReal(box.low.y - 0.5, box.high.y + 0.5);
  }
  void sampleUniformNear(ob::State* state, const ob::State* near, double distance) override {
    for (unsigned i = 0; i < 2; ++i) {
      const double value = near->as<PlaneState>()->values[i];
      state->as<PlaneState>()->values[i] = rng_.uniformReal(value - distance, value + distance);
    }
    space_->enforceBounds(state);
  }
  void sampleGaussian(ob::State* state, const ob::State* mean, double deviation) override {
    for (unsigned i = 0; i < 2; ++i) {
      state->as<PlaneState>()->values[i] =
          rng_.gaussian(mean->as<PlaneState>()->values[i], deviation);
    }
    space_->enforceBounds(state);
  }

 private:
  static constexpr double kUnguidedShare = 0.2;
  std::vector<PixelBox> boxes_;
  std::vector<double> sums_;
  double total_ = 0;
};

/// The plane seen as a coarse grid, for planners that count where they have been. OMPL 1.5's own
/// projection of the plane aborts in an assertion of Eigen.
class CoarseGrid : public ob::ProjectionEvaluator {
 public:
  explicit CoarseGrid(const ob::StateSpacePtr& plane) : ob::ProjectionEvaluator(plane) {
    setCellSizes(std::vector<double>(2, plane->getMaximumExtent() / kCellsAcross));
  }
  unsigned getDimension() const override { return 2; }
  void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> projection) const override {
    for (int i = 0; i < 2; ++i) projection(i) = state->as<PlaneState>()->values[i];
  }

 private:
  static constexpr double kCellsAcross = 40;
};

}  // namespace

ob::SpaceInformationPtr exactSpace(const FreeSpace& free) {
  auto plane = std::make_shared<ob::RealVectorStateSpace>(2);
  ob::RealVectorBounds bounds(2);
  bounds.setLow(-0.5);
  bounds.setHigh(0, free.geometry().width - 0.5);
  bounds.setHigh(1, free.geometry().height - 0.5);
  plane->setBounds(bounds);
  plane->registerDefaultProjection(std::make_shared<CoarseGrid>(plane));
  auto space = std::make_shared<ob::SpaceInformation>(plane);
  space->setStateValidityChecker(std::make_shared<FreePixels>(space, free));
  space->setMotionValidator(std::make_shared<LineOfSight>(space, free));
  space->setup();
  return space;
}

void guideSamplers(const ob::SpaceInformationPtr& space, const std::vector<PixelBox>& boxes,
                   std::uint32_t seed) {
  auto next_seed = std::make_shared<std::uint32_t>(seed);
  space->getStateSpace()->setStateSamplerAllocator(
      [boxes, next_seed](const ob::StateSpace* plane) -> ob::StateSamplerPtr {
        *next_seed = *next_seed * 1664525U + 1013904223U;
        return std::make_shared<GuidedSampler>(plane, boxes, *next_seed);
      });
}

FinePoint finePointOf(const ob::State* state) {
  const auto* values = state->as<PlaneState>()->values;
  return finePoint({values[0], values[1]});
}

void setState(ob::State* state, FinePoint point) {
  const Point2 p = coordinates(point);
  state->as<PlaneState>()->values[0] = p.x();
  state->as<PlaneState>()->values[1] = p.y();
}

void silenceOmpl() {
  static std::once_flag once;
  std::call_once(once, [] { ompl::msg::setLogLevel(ompl::msg::LOG_NONE); });
}

}  // namespace agrid::planning
