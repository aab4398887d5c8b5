// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <queue>
#include <random>
#include <string>
#include <vector>

#include "agrid/planning/planner.h"
#include "support/ascii_map.h"

namespace agrid::test {

/// A map with a meaning, by hand: areas by letters in a drawing of the map's size (none: no areas).
struct Scene {
  OccupancyGrid grid;
  std::vector<std::string> areas;  ///< 'A' is area 1 ...; other letters: no area
  std::vector<Door> doors;
  int x_lines = 1;  ///< columns of the A-Grid
  int y_lines = 1;
  double grid_yaw = 0;     ///< of the grid against the image
  unsigned line_seed = 0;  ///< not 0: the lines lie anywhere, not evenly

  Point2 at(double x, double y) const {
    const double r = grid.geometry.resolution;
    return grid.geometry.map_from_image * Point2((x + 0.5) * r, (y + 0.5) * r);
  }
  Point2 at(Pixel p) const { return at(p.x, p.y); }
};

inline Scene sceneOf(const std::vector<std::string>& rows, double resolution = 1) {
  Scene scene;
  scene.grid = asciiGrid(rows, resolution);
  return scene;
}

inline std::vector<double> evenEdges(double low, double high, int count) {
  std::vector<double> edges;
  for (int i = 0; i <= count; ++i) edges.push_back(low + (high - low) * i / count);
  return edges;
}

/// As many as even ones, but anywhere, some of them close together.
inline std::vector<double> unevenEdges(double low, double high, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<double> edges{low, high};
  for (int i = 1; i < count; ++i) {
    edges.push_back(std::uniform_real_distribution<double>(low, high)(random));
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  return edges;
}

inline std::vector<double> edgesOf(const Scene& scene, double low, double high, int count) {
  return scene.line_seed == 0 ? evenEdges(low, high, count)
                              : unevenEdges(low, high, count, scene.line_seed);
}

inline std::shared_ptr<const AGrid> gridOf(const Scene& scene) {
  const MapGeometry& g = scene.grid.geometry;
  const double w = g.width * g.resolution;
  const double h = g.height * g.resolution;
  if (scene.grid_yaw == 0) {
    return std::make_shared<const AGrid>(g.map_from_image, edgesOf(scene, 0, w, scene.x_lines),
                                         edgesOf(scene, 0, h, scene.y_lines));
  }
  // Turned about the map's middle, large enough to cover it.
  const double reach = std::hypot(w, h) / 2;
  const Pose2 image_from_grid{{w / 2, h / 2}, scene.grid_yaw};
  return std::make_shared<const AGrid>(g.map_from_image * image_from_grid,
                                       edgesOf(scene, -reach, reach, scene.x_lines),
                                       edgesOf(scene, -reach, reach, scene.y_lines));
}

inline void addAreas(const Scene& scene, SemanticMap& map) {
  const MapGeometry& g = scene.grid.geometry;
  std::vector<std::uint16_t> labels(g.pixelCount(), 0);
  for (std::size_t row = 0; row < scene.areas.size(); ++row) {
    for (std::size_t x = 0; x < scene.areas[row].size(); ++x) {
      const char letter = scene.areas[row][x];
      if (letter < 'A' || letter > 'Z') continue;
      const auto label = static_cast<std::uint16_t>(letter - 'A' + 1);
      const Pixel p{static_cast<int>(x), g.height - 1 - static_cast<int>(row)};
      labels[g.index(p)] = label;
      while (map.area_map.areas.size() < label) {
        Area area;
        area.id = AreaId{static_cast<std::uint32_t>(map.area_map.areas.size() + 1)};
        area.name = std::string(1, static_cast<char>('A' + map.area_map.areas.size()));
        map.area_map.areas.push_back(area);
      }
      map.area_map.areas[label - 1U].anchor_map = g.center(p);
    }
  }
  map.area_map.pixel_labels = std::move(labels);
}

inline std::shared_ptr<const SemanticMap> mapOf(const Scene& scene) {
  auto map = std::make_shared<SemanticMap>();
  map->structure.map = std::make_shared<const OccupancyMap>(scene.grid);
  map->structure.grid = gridOf(scene);
  addAreas(scene, *map);
  map->area_map.doors = scene.doors;
  map->area_map.cell_areas.assign(map->grid().cellCount(), AreaId{0});
  map->graph = buildGraph(map->area_map);
  return map;
}

inline PlanRequest requestFrom(const Point2& start, const Point2& goal) {
  PlanRequest request;
  request.start.position_map = start;
  PlanPoint point;
  point.position_map = goal;
  request.goal = point;
  return request;
}

/// Free space by looking at every obstacle for every pixel: the rule, and nothing clever.
class SlowFreeSpace {
 public:
  SlowFreeSpace(const Scene& scene, const PlannerParams& params, double radius)
      : geometry_(scene.grid.geometry), free_(geometry_.pixelCount()) {
    const double r_px = std::round(radius / geometry_.resolution * 1e6) / 1e6;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      free_[i] = isFarFromAll(scene, params, geometry_.pixel(i), r_px * r_px);
    }
  }

  void block(std::size_t pixel_index) { free_[pixel_index] = false; }
  bool isFree(Pixel p) const { return geometry_.contains(p) && free_[geometry_.index(p)]; }

  /// Flood fill by 4-neighbours.
  bool connects(Pixel a, Pixel b) const {
    if (!isFree(a) || !isFree(b)) return false;
    std::vector<bool> seen(free_.size());
    std::queue<Pixel> open;
    open.push(a);
    seen[geometry_.index(a)] = true;
    while (!open.empty()) {
      const Pixel p = open.front();
      open.pop();
      if (p == b) return true;
      for (const Pixel q :
           {Pixel{p.x + 1, p.y}, Pixel{p.x - 1, p.y}, Pixel{p.x, p.y + 1}, Pixel{p.x, p.y - 1}}) {
        if (!isFree(q) || seen[geometry_.index(q)]) continue;
        seen[geometry_.index(q)] = true;
        open.push(q);
      }
    }
    return false;
  }

  /// Whether a segment of the map frame touches a pixel that is not free, by trying all of them.
  bool touchesBlocked(const Point2& a_map, const Point2& b_map) const {
    const Pose2 image_from_map = inverse(geometry_.map_from_image);
    const Point2 a = image_from_map * a_map / geometry_.resolution;
    const Point2 b = image_from_map * b_map / geometry_.resolution;
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (!free_[i] && touches(geometry_.pixel(i), a, b)) return true;
    }
    return false;
  }

 private:
  static bool isFarFromAll(const Scene& scene, const PlannerParams& params, Pixel p,
                           double square) {
    const MapGeometry& g = scene.grid.geometry;
    if (p.x == 0 || p.y == 0 || p.x == g.width - 1 || p.y == g.height - 1) return false;
    for (std::size_t i = 0; i < scene.grid.values.size(); ++i) {
      const int value = scene.grid.values[i];
      if (value == 0 || (value == -1 && params.allow_unknown)) continue;
      double dx = std::abs(g.pixel(i).x - p.x);
      double dy = std::abs(g.pixel(i).y - p.y);
      if (params.clearance == Clearance::kStrict) {
        dx = std::max(dx - 1, 0.0);
        dy = std::max(dy - 1, 0.0);
      }
      if (dx * dx + dy * dy <= square) return false;
    }
    return true;
  }

  /// A segment against a closed square, a hair larger because of the way to metres and back.
  static bool touches(Pixel p, const Point2& a, const Point2& b) {
    constexpr double hair = 1e-9;
    double from = 0;
    double to = 1;
    for (int axis = 0; axis < 2; ++axis) {
      const double low = (axis == 0 ? p.x : p.y) - hair;
      const double high = low + 1 + 2 * hair;
      const double step = b[axis] - a[axis];
      if (step == 0) {
        if (a[axis] < low || a[axis] > high) return false;
        continue;
      }
      from = std::max(from, std::min((low - a[axis]) / step, (high - a[axis]) / step));
      to = std::min(to, std::max((low - a[axis]) / step, (high - a[axis]) / step));
    }
    return from <= to;
  }

  MapGeometry geometry_;
  std::vector<bool> free_;
};

/// Walls, some with gaps, and clutter.
inline OccupancyGrid randomPlan(std::mt19937& random, const MapGeometry& geometry) {
  OccupancyGrid grid;
  grid.geometry = geometry;
  grid.values.assign(geometry.pixelCount(), 0);
  const auto pick = [&](int low, int high) {
    return std::uniform_int_distribution<int>(low, std::max(low, high))(random);
  };
  const auto set = [&](int x, int y, std::int8_t value) {
    if (geometry.contains({x, y})) grid.values[geometry.index({x, y})] = value;
  };
  for (int wall = pick(1, 5); wall-- > 0;) {
    const bool vertical = pick(0, 1) == 0;
    const int length = vertical ? geometry.height : geometry.width;
    const int at = pick(0, (vertical ? geometry.width : geometry.height) - 1);
    const int gap = pick(0, length - 1);
    const int width = pick(0, 6);
    const auto value = static_cast<std::int8_t>(pick(0, 4) == 0 ? -1 : 100);
    for (int i = 0; i < length; ++i) {
      if (i >= gap && i < gap + width) continue;
      set(vertical ? at : i, vertical ? i : at, value);
    }
  }
  for (int i = pick(0, geometry.width * geometry.height / 20); i-- > 0;) {
    set(pick(0, geometry.width - 1), pick(0, geometry.height - 1), 100);
  }
  return grid;
}

}  // namespace agrid::test
