// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "agrid/geometry/segment.h"
#include "agrid/planning/costmap.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// A door that a lead goes through.
struct LeadDoor {
  DoorId id{};
  Segment jambs;  ///< in the costmap's frame [m]
};

/// A path over the static map, by areas and doors, in the costmap's frame.
struct Lead {
  bool found = false;
  std::vector<Point2> path;     ///< [m]
  std::vector<LeadDoor> doors;  ///< in order
  std::string message;          ///< why there is none
};

/// Gives the lead that goes through none of the doors named.
using LeadSource = std::function<Lead(const std::vector<DoorId>& closed)>;

struct FollowParams {
  CostRules rules;
  double band = 1;    ///< how far beside the lead its way is looked for first [m], above 0
  double detour = 3;  ///< how far around a blocked place the way is looked for next [m]
  int max_leads = 8;  ///< leads asked for before the whole costmap is searched [0..100]
};

/// What is wrong with parameters, naming field, value and bound; empty if nothing is.
std::string problemOf(const FollowParams& params);

/// A way over the costmap, in its frame.
struct FollowedPath {
  enum class Status {
    kFound,
    kStartOutside,  ///< of the costmap
    kGoalOutside,
    kGoalBlocked,  ///< no pixel within the tolerance may be entered
    kNoWay         ///< the costmap does not connect start and goal
  };
  /// Where the way came from.
  enum class Origin {
    kLead,       ///< beside the first lead
    kOtherLead,  ///< beside one that avoids blocked doors
    kCostmap     ///< the whole costmap was searched
  };
  Status status = Status::kNoWay;
  Origin origin = Origin::kLead;
  std::vector<Point2> path;           ///< from start to goal, a point at least every pixel [m]
  double cost = 0;                    ///< its length, each part times what a metre counts there [m]
  std::vector<DoorId> blocked_doors;  ///< of leads, that the costmap closes; in the order found
  std::string lead_message;           ///< why there was no lead, if there was none
};

/// Follows leads over a costmap: the cheapest way near a lead; where the lead is blocked, one
/// around the place; where that is blocked, the next lead, through other doors; in the end the
/// cheapest way over the whole costmap. So there is a path exactly where the costmap connects start
/// and goal (by the pixels' sides), and no pixel that it touches is blocked, but the start's own.
class LeadFollower {
 public:
  /// @throws std::invalid_argument if a parameter is out of range
  explicit LeadFollower(const FollowParams& params);
  ~LeadFollower();

  /// @param tolerance  how far the goal may be moved to a pixel that can be reached [m]
  FollowedPath plan(const Costmap& costmap, const Segment& start_and_goal, double tolerance,
                    const LeadSource& leads);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace agrid
