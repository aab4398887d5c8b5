// SPDX-License-Identifier: BSD-3-Clause
#include "areas/laid_cells.h"

#include <algorithm>
#include <set>

namespace agrid {

LaidCells::LaidCells(const OccupancyMap& map, const AGrid& grid, const AutomaticAreas& automatic,
                     const FormerTags* former)
    : map_(map),
      grid_(grid),
      automatic_(automatic),
      former_(former),
      stale_(grid.cellCount(), Stale::kNo),
      id_before_(automatic.area_map.areas.size() + 1, AreaId{0}),
      is_parted_(id_before_.size(), false) {
  for (const AreaGroup& group : former ? former->groups : std::vector<AreaGroup>()) {
    for (const std::uint16_t label : group.members) id_before_[label] = group.areas.front();
  }
}

std::vector<AreaId> LaidCells::label(const LaidGroups& laid, const SeatedTags& tags,
                                     const AreaMap& now) {
  std::set<const AreaGroup*> kept;
  for (std::size_t g = 0; g < tags.size(); ++g) {
    findStale(laid.groups()[g], tags[g]);
    kept.insert(laid.groups()[g].former);
  }
  for (const AreaGroup& group : former_ ? former_->groups : std::vector<AreaGroup>()) {
    if (group.slots.empty() || kept.count(&group) > 0) continue;
    addAllCells(group);
    if (group.members.empty()) addIsland(group);
  }
  std::vector<AreaId> cells = (former_ ? former_->area_map : automatic_.area_map).cell_areas;
  const CellLabeller labeller(grid_, map_.geometry(), now.pixel_labels);
  for (const std::size_t cell : stale_cells_) {
    const CellShares& shares = automatic_.cell_shares;
    const bool count = stale_[cell] == Stale::kToCount ||
                       std::any_of(shares.begin(cell), shares.end(cell),
                                   [&](const CellShare& s) { return is_parted_[s.label]; });
    const std::uint16_t most = count ? labeller.most(grid_.cell(cell)) : mostByShares(cell, now);
    cells[cell] = most == 0 ? AreaId{0} : now.areas[most - 1U].id;
  }
  return cells;
}

void LaidCells::findStale(const LaidGroup& group, const std::vector<AreaTag>& tags) {
  for (const std::uint16_t label : group.group.members) {
    is_parted_[label] = tags.size() > 1;
    if (former_ && id_before_[label] == tags.front().id) continue;
    for (const std::uint32_t cell : automatic_.cell_shares.cellsOf(label)) add(cell, Stale::kYes);
  }
  if (group.group.members.empty()) addIsland(group.group);
  if (tags.size() > 1) findStaleParts(group, tags);
}

/// Of the parts that are not the first.
void LaidCells::findStaleParts(const LaidGroup& group, const std::vector<AreaTag>& tags) {
  if (group.parts) {
    const GroupParts& parts = *group.parts;
    std::vector<cv::Rect> boxes(parts.parts.size() + 1);
    for (int y = 0; y < parts.window.height; ++y) {
      forEachRun(parts.part_of[y], parts.window.width, [&](int begin, int end, int part) {
        if (part > 1) boxes[static_cast<std::size_t>(part)] |= cv::Rect(begin, y, end - begin, 1);
      });
    }
    for (const cv::Rect& box : boxes) {
      if (box.empty()) continue;
      addBox(box + parts.window.tl());
    }
  } else if (!std::equal(tags.begin(), tags.end(), group.former->areas.begin(),
                         group.former->areas.end(),
                         [](const AreaTag& tag, AreaId id) { return tag.id == id; })) {
    addAllCells(group.group);
  }
}

void LaidCells::addAllCells(const AreaGroup& group) {
  for (const std::uint16_t label : group.members) {
    for (const std::uint32_t cell : automatic_.cell_shares.cellsOf(label)) add(cell, Stale::kYes);
  }
}

void LaidCells::add(std::size_t cell, Stale how) {
  if (stale_[cell] == Stale::kNo) stale_cells_.push_back(cell);
  stale_[cell] = std::max(stale_[cell], how);
}

void LaidCells::addBox(const cv::Rect& box) {
  for (const std::size_t cell : cellsOf(grid_, map_.geometry(), box)) add(cell, Stale::kToCount);
}

void LaidCells::addIsland(const AreaGroup& group) {
  const MapGeometry& geometry = map_.geometry();
  const auto seed = geometry.pixelAt(group.seed_map);
  cv::Rect box;
  for (const std::size_t i : islandAt(seed.value(), map_, automatic_.area_map.pixel_labels)) {
    const Pixel p = geometry.pixel(i);
    box |= cv::Rect(p.x, p.y, 1, 1);
  }
  addBox(box);
}

/// @return the label of now that most pixels of a cell have (a tie: the lowest), 0 if none has any
std::uint16_t LaidCells::mostByShares(std::size_t cell, const AreaMap& now) const {
  const CellShares& shares = automatic_.cell_shares;
  std::vector<CellShare> now_shares;
  for (const CellShare* share = shares.begin(cell); share != shares.end(cell); ++share) {
    const auto label = static_cast<std::uint16_t>(now.pixel_labels.labelOfSlot()[share->label]);
    const auto same = std::find_if(now_shares.begin(), now_shares.end(),
                                   [&](const CellShare& other) { return other.label == label; });
    if (same == now_shares.end()) {
      now_shares.push_back({label, share->pixels});
    } else {
      same->pixels += share->pixels;
    }
  }
  CellShare most;
  for (const CellShare& share : now_shares) {
    const bool more = share.pixels > most.pixels;
    if (more || (share.pixels == most.pixels && share.label < most.label)) most = share;
  }
  return most.label;
}

}  // namespace agrid
