// SPDX-License-Identifier: BSD-3-Clause
#include "planning/area_routes.h"

#include <algorithm>
#include <set>
#include <tuple>
#include <utility>

#include "planning/path_facts.h"

namespace agrid::planning {
namespace {

/// Alternatives that differ only in openings without a door, or in space without an area, are
/// dropped; so many are looked at for each one wanted.
constexpr std::size_t kSpareRoutes = 4;

}  // namespace

AreaRoutes::AreaRoutes(const SemanticMap& map, const PortalGraph& graph)
    : map_(map), graph_(graph) {
  passages_.passages.resize(graph.nodeCount());
  std::set<std::tuple<std::uint32_t, std::uint32_t, std::size_t>> joined;
  for (std::uint32_t i = 0; i < graph.portals().size(); ++i) {
    const Portal& portal = graph.portals()[i];
    places_.push_back(map.map().geometry().center(portal.middle));
    const auto [a, b] = std::minmax(portal.nodes[0], portal.nodes[1]);
    if (!joined.emplace(a, b, doorOf(portal)).second) continue;
    passages_.passages[a].push_back({i, b});
    passages_.passages[b].push_back({i, a});
  }
}

std::size_t AreaRoutes::doorOf(const Portal& portal) const {
  const std::uint32_t a = graph_.classOf(portal.nodes[0]);
  const std::uint32_t b = graph_.classOf(portal.nodes[1]);
  if (a == 0 || b == 0) return kNoDoor;
  return doorBetween(map_.area_map, a - std::size_t{1}, b - std::size_t{1}, places_.back());
}

std::vector<RouteQuery> AreaRoutes::queries(FinePoint start, const Target& target) const {
  const MapGeometry& geometry = map_.map().geometry();
  RouteQuery query;
  const std::uint32_t start_node = graph_.nodeAt(geometry.index(start.pixel()));
  query.start_area = start_node;
  query.start_map = mapPoint(geometry, start);
  if (target.point) {
    query.goal_area = graph_.nodeAt(geometry.index(target.point->pixel()));
    query.goal_map = mapPoint(geometry, *target.point);
    return {query};
  }
  std::vector<RouteQuery> queries;
  query.goal_map = map_.area_map.areas[target.label - std::size_t{1}].anchor_map;
  for (std::uint32_t node = 0; node < graph_.nodeCount(); ++node) {
    if (graph_.classOf(node) != target.label ||
        graph_.componentOf(node) != graph_.componentOf(start_node)) {
      continue;
    }
    query.goal_area = node;
    queries.push_back(query);
  }
  return queries;
}

Route AreaRoutes::named(const Route& route) const {
  Route named;
  named.length = route.length;
  for (std::size_t i = 0; i < route.areas.size(); ++i) {
    const std::uint32_t label = graph_.classOf(static_cast<std::uint32_t>(route.areas[i]));
    if (label == 0) continue;
    const std::size_t area = label - std::size_t{1};
    if (!named.areas.empty() && named.areas.back() == area) continue;
    if (!named.areas.empty()) {
      const Point2& place = places_[route.doors[i - 1]];
      named.doors.push_back(doorBetween(map_.area_map, named.areas.back(), area, place));
    }
    named.areas.push_back(area);
  }
  return named;
}

std::vector<Route> AreaRoutes::find(FinePoint start, const Target& target, std::size_t max_routes,
                                    const StopCheck& stop) const {
  std::vector<Route> candidates;
  for (const RouteQuery& query : queries(start, target)) {
    for (const Route& route :
         findRoutes(passages_, places_, query, max_routes == 1 ? 1 : max_routes * kSpareRoutes)) {
      candidates.push_back(named(route));
    }
    stop.check();
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Route& a, const Route& b) { return a.length < b.length; });
  std::vector<Route> routes;
  for (Route& candidate : candidates) {
    const bool known = std::any_of(routes.begin(), routes.end(), [&](const Route& r) {
      return r.doors == candidate.doors && r.areas == candidate.areas;
    });
    if (!known && routes.size() < max_routes) routes.push_back(std::move(candidate));
  }
  return routes;
}

}  // namespace agrid::planning
