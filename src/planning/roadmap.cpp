// SPDX-License-Identifier: BSD-3-Clause
#include "planning/roadmap.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <future>
#include <thread>
#include <utility>

#include "planning/region_classes.h"

namespace agrid::planning {
namespace {

PortalGraph regionsOf(const FreeSpace& free, const std::vector<std::uint16_t>& pixel_labels,
                      const std::vector<TurningPoint>& points, const StopCheck& stop) {
  const RegionClasses classes(free.geometry(), pixel_labels, points);
  return PortalGraph(
      free, [&](int y, std::vector<std::uint32_t>& row) { classes.classesOfRow(y, row); }, stop,
      PortalCut::kParts);
}

/// Of each region, how far its portals reach [px].
std::vector<int> reachesOf(const PortalGraph& regions) {
  std::vector<int> reaches(regions.nodeCount());
  for (const Portal& portal : regions.portals()) {
    for (const std::uint32_t region : portal.nodes) {
      reaches[region] = std::max(reaches[region], static_cast<int>(std::ceil(portal.reach)) + 1);
    }
  }
  return reaches;
}

/// The turning points of each region's paths: a path that starts anywhere on a portal's border,
/// instead of at its middle, bends at corners at most the portal's reach beyond the region.
std::vector<std::vector<TurningPoint>> pointsOfRegions(const FreeSpace& free,
                                                       const PortalGraph& regions,
                                                       const std::vector<TurningPoint>& points) {
  const MapGeometry& geometry = free.geometry();
  const std::vector<int> reaches = reachesOf(regions);
  const int window = reaches.empty() ? 0 : *std::max_element(reaches.begin(), reaches.end());
  std::vector<std::vector<TurningPoint>> points_of(regions.nodeCount());
  std::vector<std::uint32_t> near;
  for (const TurningPoint& point : points) {
    near.clear();
    const Pixel p = point.at.pixel();
    for (int y = std::max(p.y - window, 0); y <= std::min(p.y + window, geometry.height - 1); ++y) {
      for (int x = std::max(p.x - window, 0); x <= std::min(p.x + window, geometry.width - 1);
           ++x) {
        const std::uint32_t region = regions.nodeAt(geometry.index({x, y}));
        if (region == kNoNode || std::max(std::abs(x - p.x), std::abs(y - p.y)) > reaches[region] ||
            std::find(near.begin(), near.end(), region) != near.end()) {
          continue;
        }
        near.push_back(region);
        points_of[region].push_back(point);
      }
    }
  }
  return points_of;
}

/// Runs `work(i)` for each i below `count` on all cores.
template <typename Work>
void forEachInParallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::future<void>> others;
  for (unsigned i = 1; i < std::thread::hardware_concurrency(); ++i) {
    others.push_back(std::async(std::launch::async, run));
  }
  run();
  for (std::future<void>& other : others) other.get();
}

}  // namespace

Roadmap::Roadmap(const FreeSpace& free, const std::vector<std::uint16_t>& pixel_labels,
                 const StopCheck& stop)
    : Roadmap(free, pixel_labels, turningPoints(free, stop), stop) {}

Roadmap::Roadmap(const FreeSpace& free, const std::vector<std::uint16_t>& pixel_labels,
                 const std::vector<TurningPoint>& points, const StopCheck& stop)
    : regions_(regionsOf(free, pixel_labels, points, stop)) {
  rankPortals();
  buildRoads(free, points, stop);
}

void Roadmap::rankPortals() {
  rank_.resize(2 * regions_.portals().size());
  for (std::uint32_t region = 0; region < regions_.nodeCount(); ++region) {
    std::uint32_t rank = 0;
    for (const std::uint32_t portal : regions_.portalsOf(region)) {
      rank_[2 * std::size_t{portal} + regions_.portals()[portal].sideOf(region)] = rank++;
    }
  }
}

void Roadmap::buildRoads(const FreeSpace& free, const std::vector<TurningPoint>& points,
                         const StopCheck& stop) {
  std::vector<std::vector<TurningPoint>> points_of = pointsOfRegions(free, regions_, points);
  roads_.resize(regions_.nodeCount());
  forEachInParallel(roads_.size(), [&](std::size_t i) {
    stop.check();
    std::vector<const Portal*> portals;
    for (const std::uint32_t portal : regions_.portalsOf(static_cast<std::uint32_t>(i))) {
      portals.push_back(&regions_.portals()[portal]);
    }
    roads_[i] = RegionRoads(free, static_cast<std::uint32_t>(i), std::move(points_of[i]), portals);
  });
}

}  // namespace agrid::planning
