// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>

#include <ompl/base/State.h>
#include <ompl/base/StateSpace.h>

namespace agrid::planning {

/// What a motion validator says of a motion from `a` to `b` that is not free: a place up to which
/// it is, by bisection.
/// @param is_free  takes a state, returns whether the motion from `a` to it is free
template <typename IsFree>
void findLastValid(const ompl::base::StateSpacePtr& space, const ompl::base::State* a,
                   const ompl::base::State* b, const IsFree& is_free,
                   std::pair<ompl::base::State*, double>& last_valid) {
  ompl::base::State* middle = space->allocState();
  double valid = 0;
  double invalid = 1;
  for (int i = 0; i < 20; ++i) {
    const double t = (valid + invalid) / 2;
    space->interpolate(a, b, t, middle);
    (is_free(middle) ? valid : invalid) = t;
  }
  space->freeState(middle);
  last_valid.second = valid;
  if (last_valid.first != nullptr) space->interpolate(a, b, valid, last_valid.first);
}

}  // namespace agrid::planning
