// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <opencv2/core/types.hpp>

#include "areas/cell_labels.h"
#include "areas/label_painter.h"
#include "areas/laid_groups.h"

namespace agrid {

/// The areas of the A-Grid's cells from those of before. Where no door parts a group, what is known
/// of the automatic areas' pixels is added up; elsewhere the pixels of a cell are counted.
class LaidCells {
 public:
  /// @param former  nullptr: before are the automatic areas
  LaidCells(const OccupancyMap& map, const AGrid& grid, const AutomaticAreas& automatic,
            const FormerTags* former);

  /// @param now  with its areas and labels
  std::vector<AreaId> label(const LaidGroups& laid, const SeatedTags& tags, const AreaMap& now);

 private:
  enum class Stale : std::uint8_t {
    kNo,
    kYes,
    kToCount
  };  ///< parts or islands may lie in the last
  void findStale(const LaidGroup& group, const std::vector<AreaTag>& tags);
  void findStaleParts(const LaidGroup& group, const std::vector<AreaTag>& tags);
  void addAllCells(const AreaGroup& group);
  void addIsland(const AreaGroup& group);
  void addBox(const cv::Rect& box);
  void add(std::size_t cell, Stale how);
  std::uint16_t mostByShares(std::size_t cell, const AreaMap& now) const;

  const OccupancyMap& map_;
  const AGrid& grid_;
  const AutomaticAreas& automatic_;
  const FormerTags* former_;
  std::vector<Stale> stale_;  ///< of the cells
  std::vector<std::size_t> stale_cells_;
  std::vector<AreaId> id_before_;  ///< of an automatic area's first part, by its label
  std::vector<bool> is_parted_;    ///< by the automatic areas' labels
};

}  // namespace agrid
