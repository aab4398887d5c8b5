// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include <opencv2/core/types.hpp>

#include "tags/border_profile.h"

namespace agrid {

/// The shape of a region; lengths in metres.
struct RegionShape {
  double size = 0;                ///< [m^2]
  double clearance = 0;           ///< of its place farthest from the walls
  double hull_size = 0;           ///< of its convex hull [m^2]
  double rectangle_size = 0;      ///< of the smallest rectangle around it, turned as need be [m^2]
  std::vector<cv::Point2f> hull;  ///< image frame [px]
};

/// All that is known of the border between two regions.
struct BorderMeasures {
  const BorderProfile* widest = nullptr;      ///< of its stretches
  const SideProfile* smaller_side = nullptr;  ///< of the widest stretch, towards the smaller region
  const SideProfile* larger_side = nullptr;
  const RegionShape* smaller = nullptr;
  const RegionShape* larger = nullptr;
  std::size_t smaller_neighbours = 0;
  std::size_t larger_neighbours = 0;
  double common_hull_size = 0;       ///< of both regions together [m^2]
  double common_rectangle_size = 0;  ///< of both regions together [m^2]
};

/// Regions of free space and the borders between them; regions can be merged.
class RegionGraph {
 public:
  /// @param labels  row-major: the region of each pixel, below `count`, or Basins::kNone
  /// @param stretches  the borders between the regions
  RegionGraph(const std::vector<std::uint32_t>& labels, std::size_t count,
              const std::vector<Stretch>& stretches, const BorderSurvey& survey);

  std::size_t size() const { return regions_.size(); }
  const RegionShape& shape(std::uint32_t region) const { return regions_[region]; }
  /// What was said of each stretch, in their order.
  const std::vector<BorderProfile>& profiles() const { return profiles_; }

  /// Calls f(neighbour) for each region that has a border with `region`, in rising order.
  template <typename F>
  void forEachNeighbour(std::uint32_t region, F f) const {
    for (const auto& entry : borders_[region]) f(entry.first);
  }
  bool hasNeighbour(std::uint32_t region) const { return !borders_[region].empty(); }

  /// @param a, b  neighbours
  BorderMeasures measure(std::uint32_t a, std::uint32_t b) const;

  /// Joins two neighbours; the larger one keeps its number.
  /// @return that number
  std::uint32_t merge(std::uint32_t a, std::uint32_t b);

 private:
  /// A stretch of a border, as one of its two regions sees it.
  struct Side {
    std::uint32_t stretch = 0;
    std::uint8_t own = 0;  ///< which of the profile's sides is towards that region
  };
  bool isSmaller(std::uint32_t a, std::uint32_t b) const;
  void collectShapes(const std::vector<std::uint32_t>& labels, const BorderSurvey& survey);
  RegionShape together(std::uint32_t a, std::uint32_t b) const;
  void measureHull(RegionShape& shape) const;

  double resolution_;
  std::vector<RegionShape> regions_;
  std::vector<BorderProfile> profiles_;
  std::vector<std::map<std::uint32_t, std::vector<Side>>> borders_;  ///< by neighbour
};

}  // namespace agrid
