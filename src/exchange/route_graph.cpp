// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/route_graph.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <utility>

#include "exchange/plain_text.h"

namespace agrid {
namespace {

/// Places along a door that are tried, as shares of the line between its jambs.
constexpr std::array<double, 5> kTries{0.5, 0.375, 0.625, 0.25, 0.75};

struct StopPair {
  std::size_t a = 0;
  std::size_t b = 0;
  double distance = 0;  ///< as the crow flies [m]
};

/// Lengths of the ways between stops.
class Roads {
 public:
  explicit Roads(std::size_t stops) : roads_(stops) {}

  void add(std::size_t a, std::size_t b, double length) {
    roads_[a].push_back({b, length});
    roads_[b].push_back({a, length});
  }

  /// Whether there is a way of at most this length.
  bool connects(std::size_t from, std::size_t to, double most) const {
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    std::map<std::size_t, double> best{{from, 0.0}};
    queue.push({0, from});
    while (!queue.empty()) {
      const auto [length, stop] = queue.top();
      queue.pop();
      if (stop == to) return true;
      if (length > best.at(stop)) continue;
      for (const auto& [next, step] : roads_[stop]) {
        const double sum = length + step;
        if (sum > most) continue;
        const auto known = best.find(next);
        if (known != best.end() && known->second <= sum) continue;
        best[next] = sum;
        queue.push({sum, next});
      }
    }
    return false;
  }

 private:
  std::vector<std::vector<std::pair<std::size_t, double>>> roads_;
};

double lengthOf(const std::vector<Point2>& way) {
  double length = 0;
  for (std::size_t i = 1; i < way.size(); ++i) length += (way[i] - way[i - 1]).norm();
  return length;
}

class GraphMaker {
 public:
  GraphMaker(const AreaMap& areas, const WayFinder& find_way)
      : areas_(areas), find_way_(find_way), stops_of_(areas.areas.size()) {}

  RouteGraph make() {
    addStops();
    const std::size_t stops = graph_.nodes.size();
    Roads roads(stops);
    for (const StopPair& pair : pairs()) {
      if (roads.connects(pair.a, pair.b, kRouteStretch * pair.distance)) continue;
      const auto way = find_way_(graph_.nodes[pair.a].point_map, graph_.nodes[pair.b].point_map);
      if (way.empty()) continue;
      const double length = lengthOf(way);
      if (roads.connects(pair.a, pair.b, kRouteStretch * length)) continue;
      roads.add(pair.a, pair.b, length);
      addWay(pair, way);
    }
    return std::move(graph_);
  }

 private:
  bool isFree(const Point2& point) const { return !find_way_(point, point).empty(); }

  void addStops() {
    std::map<AreaId, std::size_t> index;
    for (std::size_t k = 0; k < areas_.areas.size(); ++k) {
      const Area& area = areas_.areas[k];
      index[area.id] = k;
      if (isFree(area.anchor_map)) {
        stops_of_[k].push_back(graph_.nodes.size());
        graph_.nodes.push_back({area.anchor_map, k, {}});
      } else {
        graph_.warnings.push_back("area '" + plainText(area.name) + "' has no place for the robot");
      }
    }
    for (std::size_t k = 0; k < areas_.doors.size(); ++k) {
      const Door& door = areas_.doors[k];
      if (index.count(door.areas[0]) == 0 || index.count(door.areas[1]) == 0) continue;
      addDoor(k, index.at(door.areas[0]), index.at(door.areas[1]));
    }
  }

  void addDoor(std::size_t k, std::size_t area, std::size_t other) {
    const Door& door = areas_.doors[k];
    const std::string name = "door '" + plainText(door.name) + "' ";
    if (door.state == DoorState::kClosed) {
      graph_.warnings.push_back(name + "is closed");
      return;
    }
    for (const double share : kTries) {
      const Point2 place = door.jambs_map.a + share * (door.jambs_map.b - door.jambs_map.a);
      if (!isFree(place)) continue;
      stops_of_[area].push_back(graph_.nodes.size());
      stops_of_[other].push_back(graph_.nodes.size());
      graph_.nodes.push_back({place, {}, k});
      return;
    }
    graph_.warnings.push_back(name + "has no place for the robot");
  }

  /// Of stops of one area, the nearest first.
  std::vector<StopPair> pairs() const {
    std::vector<StopPair> pairs;
    for (const std::vector<std::size_t>& stops : stops_of_) {
      for (std::size_t i = 0; i < stops.size(); ++i) {
        for (std::size_t j = i + 1; j < stops.size(); ++j) {
          const Point2 apart = graph_.nodes[stops[j]].point_map - graph_.nodes[stops[i]].point_map;
          pairs.push_back({stops[i], stops[j], apart.norm()});
        }
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const StopPair& p, const StopPair& q) { return p.distance < q.distance; });
    return pairs;
  }

  void addWay(const StopPair& pair, const std::vector<Point2>& way) {
    std::size_t last = pair.a;
    for (std::size_t i = 1; i + 1 < way.size(); ++i) {
      graph_.links.push_back({last, graph_.nodes.size()});
      last = graph_.nodes.size();
      graph_.nodes.push_back({way[i], {}, {}});
    }
    graph_.links.push_back({last, pair.b});
  }

  const AreaMap& areas_;
  const WayFinder& find_way_;
  std::vector<std::vector<std::size_t>> stops_of_;  ///< nodes of each area and its doors
  RouteGraph graph_;
};

}  // namespace

RouteGraph findRouteGraph(const SemanticMap& map, const WayFinder& find_way) {
  return GraphMaker(map.area_map, find_way).make();
}

}  // namespace agrid
