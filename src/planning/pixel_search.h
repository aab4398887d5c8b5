// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "planning/lead.h"

namespace agrid::planning {

/// What the search over pixels runs on.
struct SearchSpace {
  const FreeSpace* free = nullptr;
  const PortalGraph* graph = nullptr;                        ///< over the cells
  const std::vector<std::uint16_t>* pixel_labels = nullptr;  ///< for a target that is an area
};

/// An any-angle path over the pixels of the lead's nodes (Nash, Koenig and Tovey, "Lazy Theta*",
/// 2010). Always finds one, because the lead's nodes are connected.
/// @return corners from `start` to the target, each in sight of the next; empty if the lead does
/// not
///         connect them
std::vector<FinePoint> searchPixels(const SearchSpace& space, const Lead& lead, FinePoint start,
                                    const Target& target, const StopCheck& stop);

}  // namespace agrid::planning
