// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "agrid/planning/lead_follower.h"

namespace agrid::planning {

/// The part of a lead between the last place that was reached and the next one that can be entered.
struct LeadGap {
  Point2 from = Point2::Zero();    ///< last place reached
  Point2 middle = Point2::Zero();  ///< on the lead
  double length = 0;               ///< along the lead
  double begin = 0;                ///< along the lead from its start
};

/// What is known of a place on the lead.
enum class LeadPlace { kReached, kFree, kBlocked };

/// @param lead  a point at least every pixel
/// @return none if no place of the lead was reached, or its end was
std::optional<LeadGap> findGap(const std::vector<Point2>& lead,
                               const std::function<LeadPlace(const Point2&)>& placeAt);

/// The lead's door that lies in the gap or, if none does, at most `slack` from its ends along the
/// lead; of several, the one nearest to its middle.
/// @param doors  in the same unit as the lead
std::optional<LeadDoor> doorInGap(const std::vector<Point2>& lead,
                                  const std::vector<LeadDoor>& doors, const LeadGap& gap,
                                  double slack);

/// Whether two straight pieces have a point in common.
bool cross(const Segment& a, const Segment& b);

}  // namespace agrid::planning
