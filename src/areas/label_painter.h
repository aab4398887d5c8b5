// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "areas/laid_groups.h"

namespace agrid {

/// Tags of the parts of each group.
using SeatedTags = std::vector<std::vector<AreaTag>>;

/// Labels of the areas from labels of before.
class LabelPainter {
 public:
  /// @param former  nullptr: before are the automatic areas
  /// @param areas  whose labels are wanted, sorted by id
  LabelPainter(const MapGeometry& geometry, const AutomaticAreas& automatic,
               const FormerTags* former, const std::vector<Area>& areas);

  /// The labels after all that changed is painted over; the same ones if nothing did.
  PixelLabels paint(const LaidGroups& laid, const SeatedTags& tags) const;

 private:
  /// Whether a group's pixels are painted anew.
  bool isPainted(const LaidGroup& group) const;
  /// What becomes of the labels of before; those of pixels that are painted anew stay.
  std::vector<std::uint16_t> newLabels(const LaidGroups& laid, const SeatedTags& tags) const;
  std::uint16_t labelOf(const AreaTag& tag) const;
  void paintParts(const GroupParts& parts, const std::vector<AreaTag>& tags,
                  std::vector<std::uint16_t>& labels) const;
  void paintAutomatic(std::uint16_t automatic_label, std::uint16_t label,
                      std::vector<std::uint16_t>& labels) const;

  const MapGeometry& geometry_;
  const AutomaticAreas& automatic_;
  const FormerTags* former_;
  const AreaMap& base_;
  std::unordered_map<std::uint32_t, std::uint16_t> label_of_;
};

}  // namespace agrid
