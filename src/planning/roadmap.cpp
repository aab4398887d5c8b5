// SPDX-License-Identifier: BSD-3-Clause
#include "planning/roadmap.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <future>
#include <iterator>
#include <thread>
#include <utility>

#include "planning/known_sights.h"
#include "planning/portal_graph_patch.h"

namespace agrid::planning {
namespace {

std::shared_ptr<const PortalGraph> regionsOf(const FreeSpace& free, const RegionClasses& classes,
                                             const StopCheck& stop) {
  return std::make_shared<const PortalGraph>(
      free, [&](int y, std::vector<std::uint32_t>& row) { classes.classesOfRow(y, row); }, stop,
      PortalCut::kParts);
}

/// The turning points of each region's paths: a path that starts anywhere on a portal's border,
/// instead of at its middle, bends at corners at most the portal's reach beyond the region.
std::vector<std::vector<TurningPoint>> pointsOfRegions(const FreeSpace& free,
                                                       const PortalGraph& regions,
                                                       const std::vector<TurningPoint>& points) {
  const MapGeometry& geometry = free.geometry();
  int window = 0;
  for (std::uint32_t region = 0; region < regions.nodeCount(); ++region) {
    window = std::max(window, regions.reachOf(region));
  }
  std::vector<std::vector<TurningPoint>> points_of(regions.nodeCount());
  std::vector<std::uint32_t> near;
  for (const TurningPoint& point : points) {
    near.clear();
    const Pixel p = point.at.pixel();
    for (int y = std::max(p.y - window, 0); y <= std::min(p.y + window, geometry.height - 1); ++y) {
      for (int x = std::max(p.x - window, 0); x <= std::min(p.x + window, geometry.width - 1);
           ++x) {
        const std::uint32_t region = regions.nodeAt(geometry.index({x, y}));
        if (region == kNoNode ||
            std::max(std::abs(x - p.x), std::abs(y - p.y)) > regions.reachOf(region) ||
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

/// Those of one region.
std::vector<TurningPoint> pointsOfRegion(const FreeSpace& free, const PortalGraph& regions,
                                         std::uint32_t region) {
  const MapGeometry& geometry = free.geometry();
  const int reach = regions.reachOf(region);
  const PixelBox box = clippedTo(geometry, widened(regions.boxOf(region), reach));
  const auto isNear = [&](Pixel p) {
    if (regions.nodeAt(geometry.index(p)) == region) return true;
    const PixelBox window =
        clippedTo(geometry, {{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}});
    for (int y = window.low.y; y <= window.high.y; ++y) {
      for (int x = window.low.x; x <= window.high.x; ++x) {
        if (regions.nodeAt(geometry.index({x, y})) == region) return true;
      }
    }
    return false;
  };
  std::vector<TurningPoint> points = turningPoints(free, box, {});
  points.erase(std::remove_if(points.begin(), points.end(),
                              [&](const TurningPoint& point) { return !isNear(point.at.pixel()); }),
               points.end());
  return points;
}

std::vector<const Portal*> portalsOf(const PortalGraph& regions, std::uint32_t region) {
  std::vector<const Portal*> portals;
  for (const std::uint32_t portal : regions.portalsOf(region)) {
    portals.push_back(&regions.portals()[portal]);
  }
  return portals;
}

bool overlapsAny(const PixelBox& box, const std::vector<PixelBox>& boxes) {
  return std::any_of(boxes.begin(), boxes.end(),
                     [&](const PixelBox& other) { return overlap(box, other); });
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

Roadmap::Roadmap(const FreeSpace& free, const PixelLabels& pixel_labels, const StopCheck& stop)
    : Roadmap(free, pixel_labels, turningPoints(free, stop), stop) {}

Roadmap::Roadmap(const FreeSpace& free, const PixelLabels& pixel_labels,
                 const std::vector<TurningPoint>& points, const StopCheck& stop)
    : classes_(std::make_shared<const RegionClasses>(free.geometry(), pixel_labels, points)),
      regions_(regionsOf(free, *classes_, stop)) {
  rankPortals();
  buildRoads(free, points, stop);
}

Roadmap::Roadmap(const Roadmap& former, const Roadmap& base, const Change& change)
    : classes_(base.classes_), rank_(former.rank_), roads_(former.roads_) {
  auto regions = std::make_shared<PortalGraph>(*former.regions_);
  PortalGraphPatch patch(*regions, *base.regions_, change.free, *classes_);
  for (const PixelBox& box : change.boxes) patch.apply(box);
  patch.finish();
  regions_ = std::move(regions);
  if (!patch.changedAnything()) return;
  renewed_regions_ = patch.renewed();
  new_portals_ = patch.newPortals();
  while (rank_.size() < 2 * regions_->portals().size()) rank_.push_back(0);
  for (const std::uint32_t region : patch.relisted()) rankPortalsOf(region);
  renewRoads(base, change, patch.relisted());
}

void Roadmap::rankPortals() {
  std::vector<std::uint32_t> rank_of(2 * regions_->portals().size());
  for (std::uint32_t region = 0; region < regions_->nodeCount(); ++region) {
    std::uint32_t rank = 0;
    for (const std::uint32_t portal : regions_->portalsOf(region)) {
      rank_of[2 * std::size_t{portal} + regions_->portals()[portal].sideOf(region)] = rank++;
    }
  }
  rank_ = PagedArray<std::uint32_t, 6>(std::move(rank_of));
}

void Roadmap::rankPortalsOf(std::uint32_t region) {
  std::uint32_t rank = 0;
  for (const std::uint32_t portal : regions_->portalsOf(region)) {
    rank_.edit(2 * std::size_t{portal} + regions_->portals()[portal].sideOf(region)) = rank++;
  }
}

void Roadmap::buildRoads(const FreeSpace& free, const std::vector<TurningPoint>& points,
                         const StopCheck& stop) {
  std::vector<std::vector<TurningPoint>> points_of = pointsOfRegions(free, *regions_, points);
  std::vector<std::shared_ptr<const LazyRoads>> roads(regions_->nodeCount());
  forEachInParallel(roads.size(), [&](std::size_t i) {
    stop.check();
    const auto region = static_cast<std::uint32_t>(i);
    roads[i] = std::make_shared<const LazyRoads>(
        RegionRoads(free, region, std::move(points_of[i]), portalsOf(*regions_, region)));
  });
  roads_ = PagedArray<std::shared_ptr<const LazyRoads>, 4>(std::move(roads));
}

/// All that a region's roads depend on lies within its box, widened by what its paths may bend
/// beyond it.
void Roadmap::renewRoads(const Roadmap& base, const Change& change,
                         const std::set<std::uint32_t>& relisted) {
  while (roads_.size() < regions_->nodeCount()) roads_.push_back(nullptr);
  for (std::uint32_t region = 0; region < regions_->nodeCount(); ++region) {
    const PixelBox& box = regions_->boxOf(region);
    if (box.high.x < 0) continue;
    const PixelBox around = widened(box, regions_->reachOf(region) + 2);
    if (!overlapsAny(around, change.boxes) && relisted.count(region) == 0) continue;
    const bool as_in_base = region < base.regions_->nodeCount() &&
                            !overlapsAny(around, change.from_base) &&
                            regions_->portalsOf(region) == base.regions_->portalsOf(region);
    if (as_in_base) {
      roads_.edit(region) = base.roads_[region];
      continue;
    }
    roads_.edit(region) = std::make_shared<const LazyRoads>(renewal(region, base, change));
  }
}

/// Of a region that has pixels of one region of the base, and none else.
std::function<RegionRoads()> Roadmap::renewal(std::uint32_t region, const Roadmap& base,
                                              const Change& change) const {
  const PixelBox around = widened(regions_->boxOf(region), regions_->reachOf(region) + 2);
  std::vector<PixelBox> changed;
  std::copy_if(change.from_base.begin(), change.from_base.end(), std::back_inserter(changed),
               [&](const PixelBox& box) { return overlap(box, around); });
  const std::vector<const Portal*> portals = portalsOf(*regions_, region);
  std::uint32_t in_base = kNoNode;
  if (!portals.empty()) {
    const Portal& portal = *portals.front();
    const Pixel pixel = portal.sideOf(region) == 0 ? portal.middle : portal.beyond;
    in_base = base.regions_->nodeAt(change.free.geometry().index(pixel));
  }
  return [free = change.free, regions = regions_, base_regions = base.regions_,
          base_roads = in_base == kNoNode ? nullptr : base.roads_[in_base], in_base, region,
          changed = std::move(changed)] {
    FormerRegion former;
    if (base_roads) {
      former = {&base_roads->get(), in_base, portalsOf(*base_regions, in_base), changed};
    }
    return RegionRoads(free, region, pointsOfRegion(free, *regions, region),
                       portalsOf(*regions, region), base_roads ? &former : nullptr);
  };
}

}  // namespace agrid::planning
