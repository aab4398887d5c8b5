// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/map/map_geometry.h"
#include "planning/turning_point.h"

namespace agrid::planning {

/// Divides the map for the roadmap: into its areas, and areas with many turning points into blocks
/// with few, so that what is stored for a region stays small however large or cluttered an area is.
class RegionClasses {
 public:
  /// Side of a block [px].
  static constexpr int kBlock = 32;
  /// A region is divided while it has more turning points than this, down to one block. Sight
  /// between its points is looked for pair by pair.
  static constexpr std::uint32_t kMaxPoints = 200;

  /// @param pixel_labels  of the areas, row-major, 0 where there is none
  RegionClasses(const MapGeometry& geometry, const PixelLabels& pixel_labels,
                const std::vector<TurningPoint>& points);

  /// Writes the class of each pixel of row `y`.
  void classesOfRow(int y, std::vector<std::uint32_t>& classes) const;

  /// Of a pixel of the map.
  std::uint32_t classAt(Pixel p) const {
    return block_class_[boxes_[labels_[geometry_.index(p)]].blockAt(p.x / kBlock, p.y / kBlock)];
  }

 private:
  /// The blocks of a label's bounding box, row-major from `first` on.
  struct Box {
    int low_x = 0x7fffffff;
    int low_y = 0x7fffffff;
    int high_x = -1;
    int high_y = -1;
    std::size_t first = 0;
    std::size_t blockAt(int x, int y) const {
      return first +
             static_cast<std::size_t>(y - low_y) * static_cast<std::size_t>(high_x - low_x + 1) +
             static_cast<std::size_t>(x - low_x);
    }
  };
  void findBoxes();
  void divide(const Box& box, const Box& part, const std::vector<std::uint32_t>& points_in_block);

  MapGeometry geometry_;
  PixelLabels labels_;
  std::vector<Box> boxes_;                  ///< of the labels, in blocks
  std::vector<std::uint32_t> block_class_;  ///< of all boxes' blocks
  std::uint32_t next_class_ = 0;
};

}  // namespace agrid::planning
