// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/map_space.h"

#include <algorithm>
#include <utility>

#include "planning/ompl/last_valid.h"

namespace agrid::planning {
namespace {

namespace ob = ompl::base;

class FreePoses : public ob::StateValidityChecker {
 public:
  FreePoses(const ob::SpaceInformationPtr& space, std::shared_ptr<const SweptRobot> robot)
      : ob::StateValidityChecker(space),
        motions_(space->getStateSpace()),
        robot_(std::move(robot)) {}

  bool isValid(const ob::State* state) const override {
    const Pose2 pose = motions_.pose(state);
    if (!pose.position.allFinite() || !si_->satisfiesBounds(state)) return false;
    if (!motions_.isPlane()) return robot_->isFree(pose);
    const FinePoint p = finePoint(pixelCoordinates(robot_->free().geometry(), pose.position));
    return robot_->free().canSee(p, p);
  }
  double clearance(const ob::State* state) const override {
    return robot_->clearance(motions_.pose(state));
  }

 private:
  SpaceMotions motions_;
  std::shared_ptr<const SweptRobot> robot_;
};

class FreeMotions : public ob::MotionValidator {
 public:
  FreeMotions(const ob::SpaceInformationPtr& space, std::shared_ptr<const SweptRobot> robot)
      : ob::MotionValidator(space), motions_(space->getStateSpace()), robot_(std::move(robot)) {}

  bool checkMotion(const ob::State* a, const ob::State* b) const override {
    const bool free = isFree(a, b);
    ++(free ? valid_ : invalid_);
    return free;
  }

  bool checkMotion(const ob::State* a, const ob::State* b,
                   std::pair<ob::State*, double>& last_valid) const override {
    if (checkMotion(a, b)) return true;
    const auto is_free = [&](const ob::State* middle) { return isFree(a, middle); };
    findLastValid(si_->getStateSpace(), a, b, is_free, last_valid);
    return false;
  }

 private:
  bool isFree(const ob::State* a, const ob::State* b) const {
    const MapGeometry& geometry = robot_->free().geometry();
    if (motions_.isPlane()) {
      const auto point = [&](const ob::State* state) {
        return finePoint(pixelCoordinates(geometry, motions_.pose(state).position));
      };
      return robot_->free().canSee(point(a), point(b));
    }
    const Movement motion = motions_.between(a, b);
    // Most motions that are not free end beyond an obstacle or in one.
    return robot_->isFree(motions_.pose(b)) &&
           std::all_of(motion.begin(), motion.end(),
                       [this](const MotionPiece& piece) { return robot_->isFree(piece); });
  }

  SpaceMotions motions_;
  std::shared_ptr<const SweptRobot> robot_;
};

ob::RealVectorBounds boundsOf(const MapGeometry& geometry) {
  Point2 low = geometry.map_from_image.position;
  Point2 high = low;
  for (const double x : {0.0, geometry.width * geometry.resolution}) {
    for (const double y : {0.0, geometry.height * geometry.resolution}) {
      const Point2 corner = geometry.map_from_image * Point2(x, y);
      low = low.cwiseMin(corner);
      high = high.cwiseMax(corner);
    }
  }
  ob::RealVectorBounds bounds(2);
  for (unsigned i = 0; i < 2; ++i) {
    bounds.setLow(i, low[i]);
    bounds.setHigh(i, high[i]);
  }
  return bounds;
}

}  // namespace

void placeInMap(const ob::SpaceInformationPtr& space, std::shared_ptr<const SweptRobot> robot) {
  SpaceMotions(space->getStateSpace()).setBounds(boundsOf(robot->free().geometry()));
  space->setStateValidityChecker(std::make_shared<FreePoses>(space, robot));
  space->setMotionValidator(std::make_shared<FreeMotions>(space, robot));
}

}  // namespace agrid::planning
