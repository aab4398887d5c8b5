// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "planning/obstacles.h"
#include "planning/radius_level.h"
#include "planning/random_trial.h"

namespace agrid::test {

/// Areas of many shapes: columns, slanted strips with borders like stairs, the pixels nearest to
/// some points, and these with single pixels that belong to others.
inline void addAreasOfAnyShape(std::mt19937& random, Scene& scene) {
  const MapGeometry& g = scene.grid.geometry;
  const auto below = [&](int limit) {
    return static_cast<int>(random() % static_cast<unsigned>(limit));
  };
  std::array<Pixel, 6> seeds;
  for (Pixel& seed : seeds) seed = {below(g.width), below(g.height)};
  const int kind = below(5);
  const auto nearest = [&](Pixel p) {
    const auto square = [&](Pixel q) {
      return (p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y);
    };
    return std::min_element(seeds.begin(), seeds.end(),
                            [&](Pixel a, Pixel b) { return square(a) < square(b); }) -
           seeds.begin();
  };
  scene.areas.assign(static_cast<std::size_t>(g.height), "");
  for (int row = 0; row < g.height; ++row) {
    for (int x = 0; x < g.width; ++x) {
      const int y = g.height - 1 - row;
      auto number = kind == 0   ? x / 5
                    : kind == 1 ? (x + y) / 6
                    : kind == 2 ? (x + 2 * (g.height - y)) / 9
                                : static_cast<int>(nearest({x, y}));
      if (kind == 4 && below(4) == 0) number = below(3);
      scene.areas[static_cast<std::size_t>(row)] += static_cast<char>('A' + number % 26);
    }
  }
}

/// A map with what is prepared for a radius.
struct RoadSample {
  Scene scene;
  std::shared_ptr<const SemanticMap> map;
  std::unique_ptr<const planning::RadiusLevel> level;

  const MapGeometry& geometry() const { return scene.grid.geometry; }
  const planning::FreeSpace& free() const { return level->free; }
  const planning::Roadmap& roadmap() const { return level->roadmap; }
  const planning::PortalGraph& regions() const { return level->roadmap.regions(); }
  std::uint32_t regionAt(Pixel p) const {
    return geometry().contains(p) ? regions().nodeAt(geometry().index(p)) : planning::kNoNode;
  }
  std::vector<const planning::Portal*> portalsOf(std::uint32_t region) const {
    std::vector<const planning::Portal*> portals;
    for (const std::uint32_t p : regions().portalsOf(region)) {
      portals.push_back(&regions().portals()[p]);
    }
    return portals;
  }
  std::vector<Pixel> freePixels() const {
    std::vector<Pixel> pixels;
    for (std::size_t i = 0; i < geometry().pixelCount(); ++i) {
      if (free().isFree(geometry().pixel(i))) pixels.push_back(geometry().pixel(i));
    }
    return pixels;
  }
};

inline RoadSample roadSample(Scene scene, const PlannerParams& params) {
  RoadSample sample;
  sample.scene = std::move(scene);
  sample.map = mapOf(sample.scene);
  const MapGeometry& g = sample.scene.grid.geometry;
  const planning::Obstacles obstacles(*sample.map, params.allow_unknown, params.clearance);
  const PixelLabels& labels = sample.map->area_map.pixel_labels;
  sample.level = std::make_unique<const planning::RadiusLevel>(
      std::make_shared<const planning::RadiusRoads>(
          g, std::make_shared<const planning::ObstacleField>(g, obstacles), params.robot_radius,
          labels, planning::StopCheck{}),
      labels);
  return sample;
}

/// Robots that fit through most gaps, many of them points.
inline RoadSample randomRoadSample(std::mt19937& random) {
  Trial trial = randomTrial(random);
  const std::array<double, 6> radii_px{0, 0, 0.5, 1, 1.5, 2};
  trial.params.robot_radius =
      radii_px[random() % radii_px.size()] * trial.scene.grid.geometry.resolution;
  addAreasOfAnyShape(random, trial.scene);
  return roadSample(std::move(trial.scene), trial.params);
}

/// Lengths from one of some places to all of them: Dijkstra without a heap.
/// @param leg  its length, infinite where there is none
template <typename Leg>
std::vector<double> lengthsFrom(std::size_t source, std::size_t count, const Leg& leg) {
  std::vector<double> lengths(count, std::numeric_limits<double>::infinity());
  std::vector<bool> done(count);
  lengths[source] = 0;
  for (std::size_t round = 0; round < count; ++round) {
    std::size_t next = count;
    for (std::size_t i = 0; i < count; ++i) {
      if (!done[i] && (next == count || lengths[i] < lengths[next])) next = i;
    }
    done[next] = true;
    for (std::size_t i = 0; i < count; ++i) {
      if (!done[i]) lengths[i] = std::min(lengths[i], lengths[next] + leg(next, i));
    }
  }
  return lengths;
}

/// Pieces of the border between two pixels of a portal's two regions, in half pixels, pixel centres
/// odd: the piece's middle and its ends.
struct BorderPiece {
  Pixel low;  ///< the lower pixel
  Pixel high;
  Pixel middle() const { return {low.x + high.x + 1, low.y + high.y + 1}; }
  std::array<Pixel, 2> ends() const {
    const Pixel m = middle();
    return low.y == high.y ? std::array<Pixel, 2>{Pixel{m.x, m.y - 1}, Pixel{m.x, m.y + 1}}
                           : std::array<Pixel, 2>{Pixel{m.x - 1, m.y}, Pixel{m.x + 1, m.y}};
  }
  bool isWithin(const planning::PixelBox& corners) const {
    for (const Pixel end : ends()) {
      if (end.x < 2 * corners.low.x || end.x > 2 * corners.high.x) return false;
      if (end.y < 2 * corners.low.y || end.y > 2 * corners.high.y) return false;
    }
    return true;
  }
};

/// Those that certainly belong to a portal: no other one joins the same regions there.
inline std::vector<BorderPiece> piecesOf(const planning::PortalGraph& graph,
                                         const MapGeometry& geometry,
                                         const planning::Portal& portal) {
  const auto sameNodes = [&](std::uint32_t a, std::uint32_t b) {
    return (a == portal.nodes[0] && b == portal.nodes[1]) ||
           (b == portal.nodes[0] && a == portal.nodes[1]);
  };
  const auto isAlone = [&](const BorderPiece& piece) {
    for (const std::uint32_t i : graph.portalsOf(portal.nodes[0])) {
      const planning::Portal& other = graph.portals()[i];
      if (&other != &portal && sameNodes(other.nodes[0], other.nodes[1]) &&
          piece.isWithin(other.border)) {
        return false;
      }
    }
    return piece.isWithin(portal.border);
  };
  std::vector<BorderPiece> pieces;
  for (int y = portal.box.low.y; y <= portal.box.high.y; ++y) {
    for (int x = portal.box.low.x; x <= portal.box.high.x; ++x) {
      for (const Pixel high : {Pixel{x + 1, y}, Pixel{x, y + 1}}) {
        const BorderPiece piece{{x, y}, high};
        if (sameNodes(graph.nodeAt(geometry.index(piece.low)),
                      graph.nodeAt(geometry.index(high))) &&
            isAlone(piece)) {
          pieces.push_back(piece);
        }
      }
    }
  }
  return pieces;
}

}  // namespace agrid::test
