// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "planning/obstacles.h"

namespace agrid::planning {

class RadiusLevel;

/// A door that keeps parts of free space apart for a radius.
struct Barrier {
  std::size_t door = 0;     ///< index into AreaMap::doors
  bool too_narrow = false;  ///< whether closed or not, it would have to be wider
};

/// What keeps the components of free space apart for one radius.
class BarrierGraph {
 public:
  /// Looks at the surroundings of each door; the arguments are used only meanwhile.
  BarrierGraph(const SemanticMap& map, const RadiusLevel& level, const Obstacles& obstacles);

  /// Those of a way with the fewest barriers, in order; none if no way leads through barriers.
  /// @param goals  components, any of which will do
  std::vector<Barrier> fewestBetween(std::uint32_t start,
                                     const std::vector<std::uint32_t>& goals) const;

 private:
  void add(const Barrier& barrier, const std::vector<std::uint32_t>& components);

  std::vector<Barrier> barriers_;
  std::vector<std::vector<std::uint32_t>> beside_;                 ///< components of the barriers
  std::map<std::uint32_t, std::vector<std::size_t>> barriers_of_;  ///< of the components
};

/// A BarrierGraph that is made when it is first asked for.
class Barriers {
 public:
  const BarrierGraph& of(const SemanticMap& map, const RadiusLevel& level,
                         const Obstacles& obstacles) const;

 private:
  mutable std::once_flag made_;
  mutable std::unique_ptr<const BarrierGraph> graph_;
};

}  // namespace agrid::planning
