// SPDX-License-Identifier: BSD-3-Clause
#include "planning/region_labels.h"

#include <algorithm>
#include <utility>

#include "planning/portal_runs.h"

namespace agrid::planning {
namespace {

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

/// Calls `visit(pixel, label)` for the pixels of a region, until it returns false.
template <typename Visit>
void forEachPixelOf(const MapGeometry& geometry, const PortalGraph& regions, std::uint32_t region,
                    const PixelLabels& labels, const Visit& visit) {
  const PixelBox& box = regions.boxOf(region);
  for (int y = box.low.y; y <= box.high.y; ++y) {
    for (int x = box.low.x; x <= box.high.x; ++x) {
      const std::size_t i = geometry.index({x, y});
      if (regions.nodeAt(i) == region && !visit(Pixel{x, y}, labels[i])) return;
    }
  }
}

RegionParts findParts(const MapGeometry& geometry, const PortalGraph& regions, std::uint32_t region,
                      const PixelLabels& labels) {
  RegionParts parts;
  const PixelBox& box = regions.boxOf(region);
  PortalRuns runs(box.columns() + 1, box.low.x);
  int row = box.low.y - 1;
  forEachPixelOf(geometry, regions, region, labels, [&](Pixel p, std::uint16_t label) {
    for (; row < p.y; ++row) runs.nextRow();
    parts.boxes[label].add(p);
    for (const bool upwards : {false, true}) {
      const Pixel q = upwards ? Pixel{p.x, p.y + 1} : Pixel{p.x + 1, p.y};
      const std::size_t i = geometry.index(q);
      if (regions.nodeAt(i) == region && labels[i] != label) runs.add(p, upwards, label, labels[i]);
    }
    return true;
  });
  parts.borders = runs.portals(PortalCut::kParts);
  return parts;
}

}  // namespace

RegionLabels::RegionLabels(const MapGeometry& geometry, const PortalGraph& regions,
                           PixelLabels labels)
    : geometry_(geometry), labels_(std::move(labels)), label_of_(regions.nodeCount()) {
  for (std::size_t i = 0; i < labels_.size(); ++i) {
    if (regions.nodeAt(i) != kNoNode) label_of_[regions.nodeAt(i)] = labels_[i];
  }
}

RegionLabels::RegionLabels(const RegionLabels& former, const PortalGraph& regions,
                           PixelLabels labels)
    : geometry_(former.geometry_),
      labels_(std::move(labels)),
      label_of_(former.label_of_),
      parts_(former.parts_) {
  std::vector<std::uint32_t> changed;
  const auto width = static_cast<std::size_t>(geometry_.width);
  forEachDifference(width, former.labels_, labels_, [&](std::size_t i) {
    const std::uint32_t region = regions.nodeAt(i);
    if (region == kNoNode || (!changed.empty() && changed.back() == region)) return;
    changed.push_back(region);
  });
  std::sort(changed.begin(), changed.end());
  changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
  for (const std::uint32_t region : changed) relabel(regions, region);
}

RegionLabels::RegionLabels(const RegionLabels& former, const PortalGraph& regions,
                           const std::set<std::uint32_t>& changed)
    : geometry_(former.geometry_),
      labels_(former.labels_),
      label_of_(former.label_of_),
      parts_(former.parts_) {
  label_of_.resize(regions.nodeCount());
  for (const std::uint32_t region : changed) relabel(regions, region);
}

std::shared_ptr<const RegionParts> RegionLabels::partsOf(std::uint32_t region) const {
  const auto found = parts_.find(region);
  return found == parts_.end() ? nullptr : found->second;
}

void RegionLabels::relabel(const PortalGraph& regions, std::uint32_t region) {
  parts_.erase(region);
  label_of_[region] = 0;
  bool first = true;
  bool several = false;
  forEachPixelOf(geometry_, regions, region, labels_, [&](Pixel, std::uint16_t label) {
    if (std::exchange(first, false)) label_of_[region] = label;
    several = label != label_of_[region];
    return !several;
  });
  if (!several) return;
  parts_[region] =
      std::make_shared<const RegionParts>(findParts(geometry_, regions, region, labels_));
}

}  // namespace agrid::planning
