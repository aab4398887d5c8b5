// SPDX-License-Identifier: BSD-3-Clause
#include "planning/radius_level.h"

#include <algorithm>
#include <set>
#include <utility>

namespace agrid::planning {
namespace {

/// Regions that have other pixels than before: they or what they were made of have pixels there.
std::set<std::uint32_t> changedRegions(const Roadmap& former, const Roadmap& now,
                                       const MapGeometry& geometry,
                                       const std::vector<PixelBox>& boxes) {
  std::set<std::uint32_t> changed;
  for (const auto& renewed : now.renewedRegions()) changed.insert(renewed.first);
  for (const PixelBox& any : boxes) {
    const PixelBox box = clippedTo(geometry, any);
    for (int y = box.low.y; y <= box.high.y; ++y) {
      for (int x = box.low.x; x <= box.high.x; ++x) {
        const std::size_t i = geometry.index({x, y});
        for (const Roadmap* roadmap : {&former, &now}) {
          if (roadmap->regions().nodeAt(i) != kNoNode) changed.insert(roadmap->regions().nodeAt(i));
        }
      }
    }
  }
  return changed;
}

/// All pixels that are free or not because of doors, by this radius or a smaller one, and those of
/// forbidden areas.
std::vector<PixelBox> around(std::vector<PixelBox> doors, const FreeSpace& free,
                             const std::vector<PixelBox>& forbidden) {
  const int px = static_cast<int>(std::min(free.radiusPx(), 1e6)) + 4;
  for (PixelBox& box : doors) box = widened(box, px);
  for (const PixelBox& box : forbidden) doors.push_back(widened(box, 3));
  return doors;
}

}  // namespace

RadiusRoads::RadiusRoads(const MapGeometry& geometry, Field open_field, double robot_radius,
                         const PixelLabels& labels, const StopCheck& stop)
    : field(std::move(open_field)),
      free(geometry, field->distances(), robot_radius),
      roadmap(free, labels, stop),
      path_landmarks(roadmap, Measure::kPath, stop),
      least_landmarks(roadmap, Measure::kLeast, stop) {}

RadiusRoads::RadiusRoads(const RadiusRoads& former, const RadiusRoads& base, Field field_now,
                         std::shared_ptr<const KeepOut> keep_out)
    : field(std::move(field_now)),
      free(former.free.withDistances(field->distances()).withKeepOut(std::move(keep_out))),
      roadmap(former.roadmap, base.roadmap, {free, changedBoxes(former), changedBoxes(base)}),
      path_landmarks(former.path_landmarks, base.path_landmarks, base.roadmap, free, roadmap),
      least_landmarks(former.least_landmarks, base.least_landmarks, base.roadmap, free, roadmap) {}

std::vector<PixelBox> RadiusRoads::changedBoxes(const RadiusRoads& other) const {
  return around(field->changedBoxes(*other.field), free,
                KeepOut::changedBoxes(free.keepOut().get(), other.free.keepOut().get()));
}

const PortalGraph& AreaPieces::graph(const FreeSpace& free, const StopCheck& stop) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!graph_) {
    const auto labels_of_row = [&](int y, std::vector<std::uint32_t>& row) {
      const std::size_t first = static_cast<std::size_t>(y) * row.size();
      for (std::size_t x = 0; x < row.size(); ++x) row[x] = labels_[first + x];
    };
    graph_ = std::make_unique<const PortalGraph>(free, labels_of_row, stop);
  }
  return *graph_;
}

RadiusLevel::RadiusLevel(std::shared_ptr<const RadiusRoads> prepared_roads, PixelLabels labels)
    : prepared(std::move(prepared_roads)),
      free(prepared->free),
      roadmap(prepared->roadmap),
      path_landmarks(prepared->path_landmarks),
      least_landmarks(prepared->least_landmarks),
      region_labels_(
          std::make_shared<const RegionLabels>(free.geometry(), roadmap.regions(), labels)),
      barriers_(std::make_shared<const Barriers>()),
      pieces_(std::make_shared<const AreaPieces>(std::move(labels))) {}

RadiusLevel::RadiusLevel(const RadiusLevel& former,
                         std::shared_ptr<const RadiusRoads> prepared_roads)
    : prepared(std::move(prepared_roads)),
      free(prepared->free),
      roadmap(prepared->roadmap),
      path_landmarks(prepared->path_landmarks),
      least_landmarks(prepared->least_landmarks),
      region_labels_(std::make_shared<const RegionLabels>(
          *former.region_labels_, roadmap.regions(),
          changedRegions(former.roadmap, roadmap, free.geometry(),
                         prepared->changedBoxes(*former.prepared)))),
      barriers_(std::make_shared<const Barriers>()),
      pieces_(std::make_shared<const AreaPieces>(former.labels())) {}

RadiusLevel::RadiusLevel(const RadiusLevel& former, PixelLabels labels, bool same_doors)
    : prepared(former.prepared),
      free(prepared->free),
      roadmap(prepared->roadmap),
      path_landmarks(prepared->path_landmarks),
      least_landmarks(prepared->least_landmarks),
      region_labels_(former.labels().shares(labels)
                         ? former.region_labels_
                         : std::make_shared<const RegionLabels>(*former.region_labels_,
                                                                roadmap.regions(), labels)),
      barriers_(same_doors ? former.barriers_ : std::make_shared<const Barriers>()),
      pieces_(former.labels().shares(labels)
                  ? former.pieces_
                  : std::make_shared<const AreaPieces>(std::move(labels))) {}

}  // namespace agrid::planning
