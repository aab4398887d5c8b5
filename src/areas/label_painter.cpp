// SPDX-License-Identifier: BSD-3-Clause
#include "areas/label_painter.h"

#include <algorithm>
#include <limits>
#include <set>
#include <stdexcept>

#include "tags/pixel_runs.h"

namespace agrid {
namespace {

constexpr std::size_t kMaxSlots = std::numeric_limits<std::uint16_t>::max() + std::size_t{1};

/// The part of a group that its slots begin with.
std::size_t firstPaintedPart(const AreaGroup& group) { return group.members.empty() ? 0 : 1; }

}  // namespace

LabelPainter::LabelPainter(const OccupancyMap& map, const AutomaticAreas& automatic,
                           const FormerTags* former, const std::vector<Area>& areas)
    : map_(map),
      automatic_(automatic),
      former_(former),
      slots_((former ? former->area_map : automatic.area_map).pixel_labels.slots()) {
  for (std::size_t i = 0; i < areas.size(); ++i) {
    label_of_.emplace(static_cast<std::uint32_t>(areas[i].id), static_cast<std::uint16_t>(i + 1));
  }
}

PixelLabels LabelPainter::paint(LaidGroups& laid, const SeatedTags& tags) {
  if (former_) paintBack(laid);
  takeSlots(laid);
  label_of_slot_.assign(automatic_.area_map.areas.size() + 1, PixelLabels::kUnused);
  label_of_slot_.front() = 0;
  for (std::size_t g = 0; g < tags.size(); ++g) {
    LaidGroup& group = laid.groups()[g];
    if (group.parts) paintParts(group);
    for (const std::uint16_t label : group.group.members) set(label, tags[g].front());
    const std::size_t first = firstPaintedPart(group.group);
    for (std::size_t k = 0; k < group.group.slots.size(); ++k) {
      set(group.group.slots[k], tags[g][first + k]);
    }
  }
  const PixelLabels& base = (former_ ? former_->area_map : automatic_.area_map).pixel_labels;
  if (!painted_ && label_of_slot_ == base.labelOfSlot()) return base;
  return {std::move(slots_), std::move(label_of_slot_)};
}

void LabelPainter::set(std::uint16_t slot, const AreaTag& tag) {
  if (slot >= label_of_slot_.size()) label_of_slot_.resize(slot + 1U, PixelLabels::kUnused);
  label_of_slot_[slot] = label_of_.at(static_cast<std::uint32_t>(tag.id));
}

/// What was painted of groups that are parted otherwise now, or no more.
void LabelPainter::paintBack(const LaidGroups& laid) {
  std::set<const AreaGroup*> kept;
  for (const LaidGroup& group : laid.groups()) kept.insert(group.former);
  for (const AreaGroup& group : former_->groups) {
    if (!group.slots.empty() && kept.count(&group) == 0) paintBack(group);
  }
}

void LabelPainter::paintBack(const AreaGroup& group) {
  std::vector<bool> is_painted(kMaxSlots, false);
  for (const std::uint16_t slot : group.slots) is_painted[slot] = true;
  painted_ = true;
  for (const std::uint16_t label : group.members) {
    for (const PixelRun& run : automatic_.runs[label - 1U]) {
      paintBackRow(run.y, {run.begin, run.end}, is_painted);
    }
  }
  if (!group.members.empty()) return;
  const auto seed = map_.geometry().pixelAt(group.seed_map);
  for (const std::size_t i : islandAt(seed.value(), map_, automatic_.area_map.pixel_labels)) {
    slots_.edit(i) = 0;
  }
}

void LabelPainter::paintBackRow(int y, const cv::Range& columns,
                                const std::vector<bool>& is_painted) {
  const PixelLabels::Slots& automatic = automatic_.area_map.pixel_labels.slots();
  for (int x = columns.start; x < columns.end; ++x) {
    const std::size_t i = map_.geometry().index({x, y});
    if (is_painted[slots_[i]]) slots_.edit(i) = automatic[i];
  }
}

void LabelPainter::takeSlots(const LaidGroups& laid) {
  is_taken_.assign(automatic_.area_map.areas.size() + 1, true);
  for (const LaidGroup& group : laid.groups()) {
    for (const std::uint16_t slot : group.group.slots) {
      if (slot >= is_taken_.size()) is_taken_.resize(slot + 1U, false);
      is_taken_[slot] = true;
    }
  }
}

std::uint16_t LabelPainter::freeSlot() {
  const auto found = std::find(is_taken_.begin(), is_taken_.end(), false);
  const auto slot = static_cast<std::size_t>(found - is_taken_.begin());
  if (slot == kMaxSlots) throw std::invalid_argument("doors part the map into too many areas");
  if (found == is_taken_.end()) is_taken_.push_back(false);
  is_taken_[slot] = true;
  return static_cast<std::uint16_t>(slot);
}

void LabelPainter::paintParts(LaidGroup& group) {
  const GroupParts& parts = *group.parts;
  if (parts.part_of.empty()) return;
  const std::size_t first = firstPaintedPart(group.group);
  for (std::size_t k = first; k < parts.parts.size(); ++k) {
    group.group.slots.push_back(freeSlot());
  }
  if (group.group.slots.empty()) return;
  painted_ = true;
  for (int y = 0; y < parts.window.height; ++y) {
    const std::size_t row = map_.geometry().index({parts.window.x, parts.window.y + y});
    forEachRun(parts.part_of[y], parts.window.width, [&](int begin, int end, int part) {
      const std::size_t k = static_cast<std::size_t>(part) - 1;
      if (part == 0 || k < first) return;
      slots_.assign(row + static_cast<std::size_t>(begin),
                    std::vector<std::uint16_t>(static_cast<std::size_t>(end - begin),
                                               group.group.slots[k - first]));
    });
  }
}

}  // namespace agrid
