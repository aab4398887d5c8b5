// SPDX-License-Identifier: BSD-3-Clause
#include "planning/region_labels.h"

#include <algorithm>
#include <utility>

#include "planning/portal_runs.h"

namespace agrid::planning {
namespace {

constexpr std::int32_t kUnknown = -1;
constexpr std::int32_t kSeveral = -2;

/// What became of each label of before, as the table of slots says it: kSeveral where not all of
/// its pixels got the same.
std::vector<std::int32_t> renamed(const PixelLabels& before, const PixelLabels& now) {
  const std::vector<std::int32_t>& slots_before = before.labelOfSlot();
  const std::vector<std::int32_t>& slots_now = now.labelOfSlot();
  std::vector<std::int32_t> label_of;
  for (std::size_t slot = 0; slot < std::min(slots_before.size(), slots_now.size()); ++slot) {
    if (slots_before[slot] == PixelLabels::kUnused || slots_now[slot] == PixelLabels::kUnused) {
      continue;
    }
    const auto label = static_cast<std::size_t>(slots_before[slot]);
    if (label >= label_of.size()) label_of.resize(label + 1, kUnknown);
    if (label_of[label] == kUnknown) label_of[label] = slots_now[slot];
    if (label_of[label] != slots_now[slot]) label_of[label] = kSeveral;
  }
  return label_of;
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

/// Parts with the labels of now; nullptr if some have no label, or several the same.
template <typename NowOf>
std::shared_ptr<const RegionParts> renamed(const std::shared_ptr<const RegionParts>& parts,
                                           const NowOf& nowOf) {
  auto now = std::make_shared<RegionParts>(*parts);
  now->boxes.clear();
  for (const auto& [label, box] : parts->boxes) {
    const std::int32_t to = nowOf(label);
    if (to < 0 || !now->boxes.emplace(static_cast<std::uint16_t>(to), box).second) return nullptr;
  }
  for (Portal& border : now->borders) {
    for (std::uint32_t& label : border.nodes) {
      label = static_cast<std::uint32_t>(nowOf(static_cast<std::uint16_t>(label)));
    }
  }
  return now;
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
  const std::vector<std::int32_t> label_of = renamed(former.labels_, labels_);
  const auto nowOf = [&](std::uint16_t label) {
    return label < label_of.size() ? label_of[label] : kUnknown;
  };
  std::vector<std::uint32_t> changed;
  former.labels_.slots().forEachDifference(labels_.slots(), [&](std::size_t i) {
    const std::uint32_t region = regions.nodeAt(i);
    if (region == kNoNode || (!changed.empty() && changed.back() == region)) return;
    if (nowOf(former.labels_[i]) != labels_[i]) changed.push_back(region);
  });
  for (std::uint32_t region = 0; region < label_of_.size(); ++region) {
    const std::int32_t label = nowOf(label_of_[region]);
    if (label < 0) changed.push_back(region);
    label_of_[region] = static_cast<std::uint16_t>(std::max(label, 0));
  }
  for (auto& part : parts_) {
    part.second = renamed(part.second, nowOf);
    if (!part.second) changed.push_back(part.first);
  }
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
