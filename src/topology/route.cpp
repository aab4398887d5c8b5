// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/topology/route.h"

#include <algorithm>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

namespace agrid {
namespace {

/// What a search must avoid besides the doors that are not usable.
struct Ban {
  std::vector<std::size_t> areas;
  std::vector<std::size_t> first_doors;  ///< not as the first door
};

bool contains(const std::vector<std::size_t>& list, std::size_t value) {
  return std::find(list.begin(), list.end(), value) != list.end();
}

/// The door through which a state was entered, and the state before; the search runs over passages
/// because the way on depends on the door one came through.
struct State {
  Passage passage;
  double length = std::numeric_limits<double>::infinity();
  std::size_t before = kNoDoor;
  bool done = false;
};

class RouteSearch {
 public:
  RouteSearch(const TopologicalGraph& graph, const std::vector<Point2>& positions,
              const RouteQuery& query)
      : graph_(graph), positions_(positions), query_(query), first_(graph.passages.size() + 1) {
    for (std::size_t a = 0; a < graph.passages.size(); ++a) {
      first_[a + 1] = first_[a] + graph.passages[a].size();
    }
  }

  /// The shortest way on from an area and a point in it.
  std::optional<Route> shortest(std::size_t area, const Point2& point, const Ban& ban) const {
    if (area == query_.goal_area) return Route{{area}, {}, (query_.goal_map - point).norm()};
    std::vector<State> states(first_.back());
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto expand = [&](std::size_t from, const Point2& here, std::size_t before) {
      const double length = before == kNoDoor ? 0 : states[before].length;
      for (std::size_t i = 0; i < graph_.passages[from].size(); ++i) {
        const Passage& passage = graph_.passages[from][i];
        if (!mayUse(passage, ban, before == kNoDoor)) continue;
        State& next = states[first_[from] + i];
        const double reached = length + (positions_[passage.door] - here).norm();
        if (!(reached < next.length)) continue;
        next = {passage, reached, before, false};
        open.emplace(reached + (query_.goal_map - positions_[passage.door]).norm(),
                     first_[from] + i);
      }
    };
    expand(area, point, kNoDoor);
    while (!open.empty()) {
      const std::size_t s = open.top().second;
      open.pop();
      if (states[s].done) continue;
      states[s].done = true;
      if (states[s].passage.area == query_.goal_area) return routeTo(states, s, area);
      expand(states[s].passage.area, positions_[states[s].passage.door], s);
    }
    return std::nullopt;
  }

  /// Length of a route from the query's start to its goal.
  double lengthOf(const Route& route) const {
    Point2 here = query_.start_map;
    double length = 0;
    for (const std::size_t door : route.doors) {
      length += (positions_[door] - here).norm();
      here = positions_[door];
    }
    return length + (query_.goal_map - here).norm();
  }

 private:
  using Entry = std::pair<double, std::size_t>;

  bool mayUse(const Passage& passage, const Ban& ban, bool is_first) const {
    if (query_.usable && !query_.usable(passage.door)) return false;
    if (contains(ban.areas, passage.area)) return false;
    return !(is_first && contains(ban.first_doors, passage.door));
  }

  Route routeTo(const std::vector<State>& states, std::size_t s, std::size_t start) const {
    Route route;
    for (; s != kNoDoor; s = states[s].before) {
      route.areas.push_back(states[s].passage.area);
      route.doors.push_back(states[s].passage.door);
    }
    route.areas.push_back(start);
    std::reverse(route.areas.begin(), route.areas.end());
    std::reverse(route.doors.begin(), route.doors.end());
    return route;
  }

  const TopologicalGraph& graph_;
  const std::vector<Point2>& positions_;
  const RouteQuery& query_;
  std::vector<std::size_t> first_;
};

/// Yen's step: the shortest route that leaves `route` after its first `kept` doors.
std::optional<Route> deviate(const RouteSearch& search, const std::vector<Point2>& positions,
                             const RouteQuery& query, const std::vector<Route>& found,
                             std::size_t kept) {
  const Route& route = found.back();
  const auto doors_end = route.doors.begin() + static_cast<std::ptrdiff_t>(kept);
  const auto areas_end = route.areas.begin() + static_cast<std::ptrdiff_t>(kept);
  Ban ban;
  ban.areas.assign(route.areas.begin(), areas_end + 1);
  for (const Route& other : found) {
    if (other.doors.size() > kept &&
        std::equal(route.doors.begin(), doors_end, other.doors.begin()))
      ban.first_doors.push_back(other.doors[kept]);
  }
  const Point2 point = kept == 0 ? query.start_map : positions[route.doors[kept - 1]];
  const auto rest = search.shortest(route.areas[kept], point, ban);
  if (!rest) return std::nullopt;
  Route whole;
  whole.areas.assign(route.areas.begin(), areas_end);
  whole.doors.assign(route.doors.begin(), doors_end);
  whole.areas.insert(whole.areas.end(), rest->areas.begin(), rest->areas.end());
  whole.doors.insert(whole.doors.end(), rest->doors.begin(), rest->doors.end());
  whole.length = search.lengthOf(whole);
  return whole;
}

bool isBetter(const Route& a, const Route& b) {
  return std::tie(a.length, a.doors) < std::tie(b.length, b.doors);
}

void requireNode(const TopologicalGraph& graph, const char* field, std::size_t area) {
  if (area < graph.passages.size()) return;
  throw std::invalid_argument(std::string("RouteQuery.") + field + ": " + std::to_string(area) +
                              " is not below " + std::to_string(graph.passages.size()));
}

}  // namespace

std::vector<Route> findRoutes(const TopologicalGraph& graph,
                              const std::vector<Point2>& door_positions, const RouteQuery& query,
                              std::size_t max_routes) {
  requireNode(graph, "start_area", query.start_area);
  requireNode(graph, "goal_area", query.goal_area);
  const RouteSearch search(graph, door_positions, query);
  std::vector<Route> found;
  if (max_routes == 0) return found;
  auto best = search.shortest(query.start_area, query.start_map, {});
  if (!best) return found;
  best->length = search.lengthOf(*best);
  found.push_back(std::move(*best));
  std::vector<Route> candidates;
  while (found.size() < max_routes) {
    for (std::size_t kept = 0; kept < found.back().doors.size(); ++kept) {
      auto candidate = deviate(search, door_positions, query, found, kept);
      const auto isSame = [&](const Route& r) { return r.doors == candidate->doors; };
      if (!candidate || std::any_of(candidates.begin(), candidates.end(), isSame)) continue;
      candidates.push_back(std::move(*candidate));
    }
    if (candidates.empty()) break;
    const auto next = std::min_element(candidates.begin(), candidates.end(), isBetter);
    found.push_back(std::move(*next));
    candidates.erase(next);
  }
  return found;
}

std::optional<Route> findRoute(const AreaMap& areas, const TopologicalGraph& graph,
                               std::size_t start_area, std::size_t goal_area,
                               const DoorFilter& usable) {
  std::vector<Point2> positions;
  for (const Door& door : areas.doors) positions.push_back(door.jambs_map.midpoint());
  RouteQuery query{start_area, goal_area, Point2::Zero(), Point2::Zero(), usable};
  requireNode(graph, "start_area", start_area);
  requireNode(graph, "goal_area", goal_area);
  query.start_map = areas.areas[start_area].anchor_map;
  query.goal_map = areas.areas[goal_area].anchor_map;
  auto routes = findRoutes(graph, positions, query, 1);
  if (routes.empty()) return std::nullopt;
  return std::move(routes.front());
}

}  // namespace agrid
