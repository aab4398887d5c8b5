// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "areas/laid_groups.h"

namespace agrid {

/// Tags of the parts of each group.
using SeatedTags = std::vector<std::vector<AreaTag>>;

/// Labels of the areas from labels of before. An automatic area's pixels hold its label as their
/// slot; those of a group's smaller parts hold slots of their own, and so do those of islands. So
/// only what doors part is painted: the table of slots does the rest.
class LabelPainter {
 public:
  /// @param former  nullptr: before are the automatic areas
  /// @param areas  whose labels are wanted, sorted by id
  LabelPainter(const OccupancyMap& map, const AutomaticAreas& automatic, const FormerTags* former,
               const std::vector<Area>& areas);

  /// The labels after all that changed is painted over; the same ones if nothing did. Sets the
  /// groups' slots.
  /// @throws std::invalid_argument if there are more parts than slots
  PixelLabels paint(LaidGroups& laid, const SeatedTags& tags);

 private:
  void paintBack(const LaidGroups& laid);
  void paintBack(const AreaGroup& group);
  void paintBackRow(int y, const cv::Range& columns, const std::vector<bool>& is_painted);
  void takeSlots(const LaidGroups& laid);
  std::uint16_t freeSlot();
  void paintParts(LaidGroup& group);
  void set(std::uint16_t slot, const AreaTag& tag);

  const OccupancyMap& map_;
  const AutomaticAreas& automatic_;
  const FormerTags* former_;
  std::unordered_map<std::uint32_t, std::uint16_t> label_of_;
  PixelLabels::Slots slots_;
  std::vector<std::int32_t> label_of_slot_;
  std::vector<bool> is_taken_;
  bool painted_ = false;
};

}  // namespace agrid
