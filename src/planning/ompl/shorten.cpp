// SPDX-License-Identifier: BSD-3-Clause
#include "planning/ompl/shorten.h"

#include <utility>

#include <ompl/geometric/PathSimplifier.h>

#include "planning/ompl/exact_space.h"
#include "planning/tighten.h"

namespace agrid::planning {
namespace {

namespace og = ompl::geometric;

/// OMPL seeds its generators one after the other for the whole process; a path must depend on its
/// request alone.
class SeededSimplifier : public og::PathSimplifier {
 public:
  SeededSimplifier(const ompl::base::SpaceInformationPtr& space, std::uint32_t seed)
      : og::PathSimplifier(space) {
    rng_.setLocalSeed(seed);
  }
};

og::PathGeometric toOmpl(const ompl::base::SpaceInformationPtr& space,
                         const std::vector<FinePoint>& path) {
  og::PathGeometric result(space);
  ompl::base::State* state = space->allocState();
  for (const FinePoint p : path) {
    setState(state, p);
    result.append(state);
  }
  space->freeState(state);
  return result;
}

}  // namespace

bool passesOmplCheck(const FreeSpace& free, const std::vector<FinePoint>& path) {
  return toOmpl(exactSpace(free), path).check();
}

void shortenByOmpl(const FreeSpace& free, std::uint32_t seed, std::vector<FinePoint>& path) {
  if (path.size() < 3) return;
  const auto space = exactSpace(free);
  og::PathGeometric shorter = toOmpl(space, path);
  SeededSimplifier simplifier(space, seed);
  simplifier.reduceVertices(shorter);
  simplifier.shortcutPath(shorter);
  std::vector<FinePoint> corners;
  for (const ompl::base::State* state : shorter.getStates()) corners.push_back(finePointOf(state));
  // Corners that the simplifier put between states were rounded to the lattice after its checks.
  if (lengthPx(corners) < lengthPx(path) && passesOmplCheck(free, corners)) {
    path = std::move(corners);
  }
}

}  // namespace agrid::planning
