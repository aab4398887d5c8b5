// SPDX-License-Identifier: BSD-3-Clause
#include "planning/radius_level.h"

#include <algorithm>
#include <utility>

namespace agrid::planning {
namespace {

std::vector<std::uint16_t> labelsOf(const PortalGraph& regions, const PixelLabels& labels) {
  std::vector<std::uint16_t> label_of(regions.nodeCount());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (regions.nodeAt(i) != kNoNode) label_of[regions.nodeAt(i)] = labels[i];
  }
  return label_of;
}

/// Calls `visit(pixel)` for the pixels at which labels differ.
template <typename Visit>
void forEachDifference(std::size_t width, const PixelLabels& a, const PixelLabels& b,
                       const Visit& visit) {
  const std::uint16_t* row_a = a.data();
  const std::uint16_t* row_b = b.data();
  for (std::size_t first = 0; first < a.size(); first += width) {
    if (std::equal(row_a + first, row_a + first + width, row_b + first)) continue;
    for (std::size_t i = first; i < first + width; ++i) {
      if (row_a[i] != row_b[i]) visit(i);
    }
  }
}

/// Whether all pixels of a region have the same label.
bool hasOneLabel(const MapGeometry& geometry, const PortalGraph& regions, std::uint32_t region,
                 const PixelLabels& labels, std::uint16_t label) {
  const PixelBox& box = regions.boxOf(region);
  for (int y = box.low.y; y <= box.high.y; ++y) {
    for (int x = box.low.x; x <= box.high.x; ++x) {
      const std::size_t i = geometry.index({x, y});
      if (regions.nodeAt(i) == region && labels[i] != label) return false;
    }
  }
  return true;
}

/// All pixels that are free or not because of doors, by this radius or a smaller one.
std::vector<PixelBox> aroundDoors(std::vector<PixelBox> doors, const FreeSpace& free) {
  const int px = static_cast<int>(std::min(free.radiusPx(), 1e6)) + 4;
  for (PixelBox& box : doors) box = widened(box, px);
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

RadiusRoads::RadiusRoads(const RadiusRoads& former, const RadiusRoads& base, Field field_now)
    : field(std::move(field_now)),
      free(former.free.withDistances(field->distances())),
      roadmap(former.roadmap, base.roadmap,
              {free, aroundDoors(field->changedBoxes(*former.field), free),
               aroundDoors(field->closedBoxes(), free)}),
      path_landmarks(former.path_landmarks, base.path_landmarks, base.roadmap, free, roadmap),
      least_landmarks(former.least_landmarks, base.least_landmarks, base.roadmap, free, roadmap) {}

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
      label_of_(
          std::make_shared<const std::vector<std::uint16_t>>(labelsOf(roadmap.regions(), labels))),
      barriers_(std::make_shared<const Barriers>()),
      pieces_(std::make_shared<const AreaPieces>(std::move(labels))) {}

RadiusLevel::RadiusLevel(const RadiusLevel& former,
                         std::shared_ptr<const RadiusRoads> prepared_roads)
    : prepared(std::move(prepared_roads)),
      free(prepared->free),
      roadmap(prepared->roadmap),
      path_landmarks(prepared->path_landmarks),
      least_landmarks(prepared->least_landmarks),
      barriers_(std::make_shared<const Barriers>()),
      pieces_(std::make_shared<const AreaPieces>(former.labels())) {
  auto label_of = std::make_shared<std::vector<std::uint16_t>>(*former.label_of_);
  label_of->resize(roadmap.regions().nodeCount());
  for (const auto& [region, pixel] : roadmap.renewedRegions()) {
    (*label_of)[region] = pixel ? labels()[free.geometry().index(*pixel)] : std::uint16_t{0};
  }
  label_of_ = std::move(label_of);
}

RadiusLevel::RadiusLevel(const RadiusLevel& former, PixelLabels labels,
                         std::shared_ptr<const std::vector<std::uint16_t>> label_of,
                         bool same_doors)
    : prepared(former.prepared),
      free(prepared->free),
      roadmap(prepared->roadmap),
      path_landmarks(prepared->path_landmarks),
      least_landmarks(prepared->least_landmarks),
      label_of_(std::move(label_of)),
      barriers_(same_doors ? former.barriers_ : std::make_shared<const Barriers>()),
      pieces_(former.labels().shares(labels)
                  ? former.pieces_
                  : std::make_shared<const AreaPieces>(std::move(labels))) {}

std::shared_ptr<const std::vector<std::uint16_t>> RadiusLevel::labelsOfRegions(
    const PixelLabels& labels) const {
  if (labels.shares(this->labels())) return label_of_;
  const PortalGraph& regions = roadmap.regions();
  auto label_of = std::make_shared<std::vector<std::uint16_t>>(*label_of_);
  std::vector<std::uint32_t> changed;
  const auto width = static_cast<std::size_t>(free.geometry().width);
  forEachDifference(width, this->labels(), labels, [&](std::size_t i) {
    const std::uint32_t region = regions.nodeAt(i);
    if (region == kNoNode || (!changed.empty() && changed.back() == region)) return;
    changed.push_back(region);
    (*label_of)[region] = labels[i];
  });
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  for (const std::uint32_t region : changed) {
    if (!hasOneLabel(free.geometry(), regions, region, labels, (*label_of)[region])) return nullptr;
  }
  return label_of;
}

}  // namespace agrid::planning
