// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/map/map_geometry.h"
#include "planning/portal_graph.h"

namespace agrid::planning {

/// What the areas have of a region that holds pixels of several.
struct RegionParts {
  std::map<std::uint16_t, PixelBox> boxes;  ///< of the pixels with each label
  std::vector<Portal> borders;              ///< where they meet in the region; its nodes are labels
};

/// Which areas the regions are pieces of. Regions follow the areas that there were when they were
/// prepared; after an edit one may hold pixels of several.
class RegionLabels {
 public:
  RegionLabels(const MapGeometry& geometry, const PortalGraph& regions, PixelLabels labels);
  /// The same regions, other areas.
  RegionLabels(const RegionLabels& former, const PortalGraph& regions, PixelLabels labels);
  /// The same areas, other regions.
  /// @param changed  regions that have other pixels than before
  RegionLabels(const RegionLabels& former, const PortalGraph& regions,
               const std::set<std::uint32_t>& changed);

  const PixelLabels& labels() const { return labels_; }
  /// Of a region that holds pixels of one area.
  std::uint16_t labelOf(std::uint32_t region) const { return label_of_[region]; }
  /// nullptr if all pixels of a region have its label.
  std::shared_ptr<const RegionParts> partsOf(std::uint32_t region) const;
  /// All regions with several labels.
  const std::map<std::uint32_t, std::shared_ptr<const RegionParts>>& parts() const {
    return parts_;
  }

 private:
  void relabel(const PortalGraph& regions, std::uint32_t region);

  MapGeometry geometry_;
  PixelLabels labels_;
  std::vector<std::uint16_t> label_of_;
  std::map<std::uint32_t, std::shared_ptr<const RegionParts>> parts_;
};

}  // namespace agrid::planning
