// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include <ompl/base/Planner.h>
#include <ompl/base/SpaceInformation.h>

#include "planning/ompl/lead_path.h"
#include "planning/ompl/space_motions.h"

namespace agrid::planning {

/// Plans in any space that SpaceMotions knows, along a path for a robot that turns on the spot. A
/// roadmap of poses near that lead, whose motions are checked only when a best path through it uses
/// them (Bohlin and Kavraki 2000: Lazy PRM), grows where the search got stuck last, and a little
/// everywhere, until it holds a path. The same input gives the same path.
class LeadRoadmap {
 public:
  /// @param space  set up; its validity checker and motion validator decide
  /// @param scale  over how long a way the robot's motions bend [m]
  LeadRoadmap(ompl::base::SpaceInformationPtr space, LeadPath lead, double scale,
              std::uint32_t seed);
  ~LeadRoadmap();
  LeadRoadmap(const LeadRoadmap&) = delete;
  LeadRoadmap& operator=(const LeadRoadmap&) = delete;

  /// States of which any may be the first or last of the path; valid ones.
  void addStart(const ompl::base::State* state);
  void addGoal(const ompl::base::State* state);

  /// Grows until there is a path from a start to a goal, at most so many times; `stop` is asked
  /// after every motion. Can be called again to go on.
  /// @return the states of the path, owned by this object; none if there is none yet
  std::vector<const ompl::base::State*> solve(const ompl::base::PlannerTerminationCondition& stop,
                                              int rounds);

  void getData(ompl::base::PlannerData& data) const;

 private:
  enum class Check : std::uint8_t { kNotYet, kFree, kBlocked };
  struct Edge {
    std::uint32_t to;
    Check check;
    double length;
  };
  struct Node {
    ompl::base::State* state;
    Pose2 pose;
    double remaining;  ///< way along the lead to its end [m]
    bool is_goal = false;
    std::size_t linked = 0;  ///< nodes before this one were looked at for edges
    std::vector<Edge> edges;
  };
  class Search;

  void add(const Pose2& pose, double along);
  void addNode(ompl::base::State* owned, double along);
  void addUniform();
  void addLeadItself();
  void grow(const ompl::base::PlannerTerminationCondition& stop);
  void link(std::size_t node);

  ompl::base::SpaceInformationPtr space_;
  SpaceMotions motions_;
  LeadPath lead_;
  LeadSamples samples_;
  std::vector<Node> nodes_;
  std::vector<std::uint32_t> starts_;
  double reach_ = 0;  ///< of motions [m]
  double stuck_ = 0;  ///< how far along the lead the last search came [m]
  int rounds_ = 0;
};

/// Shortens a path by motions between states that lie on it, and leaves out states that it can do
/// without. Every motion stays valid.
/// @param path  states to which `space` has the ownership; replaced
void shortenAlong(const ompl::base::SpaceInformationPtr& space, std::uint32_t seed,
                  const ompl::base::PlannerTerminationCondition& stop,
                  std::vector<ompl::base::State*>& path);

}  // namespace agrid::planning
