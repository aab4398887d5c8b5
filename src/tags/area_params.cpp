// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "agrid/tags/tag_proposal.h"

namespace agrid {
namespace {

struct Bounds {
  const char* field;
  double value;
  double min;
  double max;
};

void check(const Bounds& b) {
  if (b.value >= b.min && b.value <= b.max) return;
  std::ostringstream what;
  what << "AreaParams::" << b.field << " is " << b.value << ", must lie in [" << b.min << ", "
       << b.max << "]";
  throw std::invalid_argument(what.str());
}

}  // namespace

void validate(const AreaParams& params) {
  const PassageParams& passages = params.passages;
  for (const Bounds& bounds : {
           Bounds{"max_clutter_diagonal", params.max_clutter_diagonal, 0, 100},
           Bounds{"min_island_size", params.min_island_size, 0, 1e6},
           Bounds{"min_separation", params.min_separation, 0, 1},
           Bounds{"merge_ratio", params.merge_ratio, 1e-3, 1},
           Bounds{"min_prominence", params.min_prominence, 0, 100},
           Bounds{"min_area_size", params.min_area_size, 0, 1e6},
           Bounds{"min_area_clearance", params.min_area_clearance, 0, 100},
           Bounds{"max_door_width", params.max_door_width, 0, 1e3},
           Bounds{"min_border_length", params.min_border_length, 0, 1e3},
           Bounds{"passages.min_width", passages.min_width, 0, 100},
           Bounds{"passages.max_width", passages.max_width, passages.min_width, 100},
           Bounds{"passages.max_skew_deg", passages.max_skew_deg, 0, 45},
           Bounds{"passages.min_spacing", passages.min_spacing, 0, 100},
           Bounds{"passages.support_reach", passages.support_reach, 0, 10},
           Bounds{"passages.min_support", passages.min_support, 0, 10},
           Bounds{"passages.opening", passages.opening, 0, 10},
       }) {
    check(bounds);
  }
}

}  // namespace agrid
