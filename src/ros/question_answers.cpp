// SPDX-License-Identifier: BSD-3-Clause
#include "ros/question_answers.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "ros/request_error.h"
#include "ros/text.h"
#include "ros/way_to_things.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

/// A thing and how far it is by path.
struct Match {
  agrid::Thing thing;
  double distance = std::numeric_limits<double>::infinity();  // [m]
};

/// How far the things are, the nearest first, and why one cannot be reached.
struct Distances {
  std::vector<Match> matches;
  std::string problem;  ///< empty: all can
};

Distances distancesTo(const std::vector<agrid::Thing>& things, const WayFinder& ways,
                      const agrid::PlanRequest& wanted) {
  Distances distances;
  for (const agrid::Thing& thing : things) {
    Match match{thing};
    const agrid::Plan plan = ways.planTo(thing, wanted, false);
    if (plan.status == agrid::PlanStatus::kCancelled) {
      throw RequestError(Status::CANCELLED, plan.message);
    }
    if (plan.status == agrid::PlanStatus::kSuccess) {
      match.distance = plan.length;
    } else if (distances.problem.empty()) {
      distances.problem = statusOf(plan.status, plan.message).message;
    }
    distances.matches.push_back(match);
  }
  std::stable_sort(distances.matches.begin(), distances.matches.end(),
                   [](const Match& a, const Match& b) { return a.distance < b.distance; });
  return distances;
}

}  // namespace

agrid_map::LabelAt::Response answerLabelAt(const Ground& ground,
                                           const agrid_map::LabelAt::Request& request) {
  const agrid::SemanticMap& map = *ground.snapshot.map;
  const agrid::Point2 point = ground.frames.point(request.point);
  const auto cell = map.grid().cellAt(point);
  if (!cell || !map.map().geometry().pixelAt(point)) {
    throw RequestError(Status::OUTSIDE, "(" + formatNumber(point.x()) + ", " +
                                            formatNumber(point.y()) + ") in '" +
                                            ground.snapshot.frame() + "' is not on the map");
  }
  agrid_map::LabelAt::Response response;
  response.row = static_cast<std::uint32_t>(cell->row);
  response.column = static_cast<std::uint32_t>(cell->column);
  response.center = toMsg(map.grid().cellCenter(*cell));
  response.area = static_cast<std::uint32_t>(map.area_map.cell_areas.at(map.grid().index(*cell)));
  response.symbols = agrid::symbolsAt(map, *cell);
  return response;
}

agrid_map::WhereIs::Response answerWhereIs(const Ground& ground,
                                           const agrid_map::WhereIs::Request& request) {
  const Snapshot& snapshot = ground.snapshot;
  const TimeLimit limit(0, snapshot.parameters->planner.timeout, ground.waited);
  limit.requireTime();
  const Frames frames = ground.frames.until(limit.deadline());
  agrid::PlanRequest wanted;
  wanted.cancelled = &ground.cancelled;
  if (request.start_from_robot) {
    wanted.start.position_map = frames.robotPose(snapshot.parameters->node.base_frame).position;
  } else {
    wanted.start = frames.planPoint(request.start);
  }
  const agrid::SemanticMap& map = *snapshot.map;
  const agrid::FoundThings found = findThings(map, request.name, {true, true});
  const Distances distances = distancesTo(found.things, {*snapshot.planner, limit, &map}, wanted);
  agrid_map::WhereIs::Response response;
  response.status.message = withRemark(found, distances.problem);
  for (const Match& match : distances.matches) {
    response.matches.push_back(tagOf(match.thing, snapshot.stamp.header));
    response.distances.push_back(match.distance);
  }
  return response;
}

agrid_map::GetAGrid::Response answerGetAGrid(const Ground& ground,
                                             const agrid_map::GetAGrid::Request&) {
  agrid_map::GetAGrid::Response response;
  response.agrid = gridToMsg(*ground.snapshot.map, ground.snapshot.stamp);
  return response;
}

agrid_map::GetGraph::Response answerGetGraph(const Ground& ground,
                                             const agrid_map::GetGraph::Request&) {
  agrid_map::GetGraph::Response response;
  response.graph = graphToMsg(*ground.snapshot.map, ground.snapshot.stamp);
  return response;
}

}  // namespace agrid_map_ros
