// SPDX-License-Identifier: BSD-3-Clause
#include "planning/roadmap.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <thread>
#include <utility>

#include "planning/region_classes.h"

namespace agrid::planning {
namespace {

/// Portals are cut to this length [px]: the shorter, the nearer are the least lengths to the true
/// ones, and the more there is to store.
constexpr int kPortalLength = 3;

PortalGraph regionsOf(const FreeSpace& free, const std::vector<std::uint16_t>& pixel_labels,
                      const std::vector<TurningPoint>& points, const StopCheck& stop) {
  const RegionClasses classes(free.geometry(), pixel_labels, points);
  return PortalGraph(
      free, [&](int y, std::vector<std::uint32_t>& row) { classes.classesOfRow(y, row); }, stop,
      kPortalLength);
}

/// The turning points of each region's paths: a path that starts anywhere on a portal's border,
/// instead of at its middle, bends at corners at most a portal's reach beyond the region.
std::vector<std::vector<TurningPoint>> pointsOfRegions(const FreeSpace& free,
                                                       const PortalGraph& regions,
                                                       const std::vector<TurningPoint>& points) {
  const MapGeometry& geometry = free.geometry();
  std::vector<std::vector<TurningPoint>> points_of(regions.nodeCount());
  std::vector<std::uint32_t> near;
  for (const TurningPoint& point : points) {
    near.clear();
    const Pixel p = point.at.pixel();
    const Pixel low{std::max(p.x - kPortalLength, 0), std::max(p.y - kPortalLength, 0)};
    const Pixel high{std::min(p.x + kPortalLength, geometry.width - 1),
                     std::min(p.y + kPortalLength, geometry.height - 1)};
    for (int y = low.y; y <= high.y; ++y) {
      for (int x = low.x; x <= high.x; ++x) {
        const std::uint32_t region = regions.nodeAt(geometry.index({x, y}));
        if (region == kNoNode || std::find(near.begin(), near.end(), region) != near.end())
          continue;
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
    : regions_([&] {
        const std::vector<TurningPoint> points = turningPoints(free, stop);
        return regionsOf(free, pixel_labels, points, stop);
      }()) {
  rankPortals();
  label_of_.resize(regions_.nodeCount());
  for (std::size_t i = 0; i < pixel_labels.size(); ++i) {
    if (regions_.nodeAt(i) != kNoNode) label_of_[regions_.nodeAt(i)] = pixel_labels[i];
  }
  buildRoads(free, turningPoints(free, stop), stop);
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
