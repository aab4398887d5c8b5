// SPDX-License-Identifier: BSD-3-Clause
#include "tags/separation.h"

#include <algorithm>
#include <cmath>

namespace agrid {
namespace {

double logAtLeast(double value, double floor) { return std::log(std::max(value, floor)); }

/// How much wider than its border a region is at one of SideProfile::kDistances, as a logarithm.
double widening(const SideProfile& side, std::size_t at, double width) {
  return std::clamp(logAtLeast(side.widths[at] / width, 0.3), -1.2, 1.2);
}

/// How many squares as wide as its widest place a region is long, as a logarithm.
double elongation(const RegionShape& region) {
  const double width = 2 * region.clearance;
  return std::log(region.size / (width * width) + 0.1);
}

double fill(double size, double around) { return size / std::max(around, 1e-3); }

/// The opening between the jambs: its width, and how the regions widen behind it.
double openingTerms(const BorderMeasures& m, double width) {
  const double log_width = logAtLeast(width, 0.1);
  const double near = widening(*m.smaller_side, 1, width);
  const double far = widening(*m.smaller_side, 2, width);
  const double least_far = std::min(far, widening(*m.larger_side, 2, width));
  const double least_farther =
      std::min(widening(*m.smaller_side, 3, width), widening(*m.larger_side, 3, width));
  const double depth = std::min(m.larger_side->depth / width, 10.);
  return -0.72234 * log_width * log_width - 0.39536 * near + 1.12736 * far +
         0.34220 * least_farther - 0.69210 * least_far * log_width -
         0.73334 * std::clamp(logAtLeast(depth, 0.05), -2., 2.3) +
         (m.smaller_side->widths[0] > 0 ? 0 : 1.28341);
}

/// The walls at the jambs and along their line.
double wallTerms(const BorderMeasures& m, double width) {
  const BorderProfile& border = *m.widest;
  const double wall_ratio = (border.wall_runs[0] + border.wall_runs[1]) / width;
  const double line = std::min(border.line_runs[0], border.line_runs[1]);
  const bool is_flat = border.is_flat[0] || border.is_flat[1];
  const bool is_flat_twice = border.is_flat[0] && border.is_flat[1];
  const double narrowness =
      border.clearance / std::max(0.01, std::min(m.smaller->clearance, m.larger->clearance));
  return -10.02052 * border.walls_at_jambs + 0.32538 * std::min(wall_ratio, 4.) +
         0.19763 * line / 4 - (is_flat ? 0.57879 : 0) +
         (is_flat_twice ? 0.55292 * std::min(narrowness, 1.5) : 0);
}

/// The shapes of the regions on their own and together.
double shapeTerms(const BorderMeasures& m, double width) {
  const RegionShape& small = *m.smaller;
  const RegionShape& large = *m.larger;
  const double clearance = std::max(small.clearance, 0.01);
  const double width_ratio = std::clamp(logAtLeast(width / 2 / clearance, 0.05), -2.5, 0.5);
  const double narrowness = std::min(m.widest->clearance / clearance, 1.5);
  const double small_fill = fill(small.size, small.rectangle_size);
  const double large_fill = fill(large.size, large.rectangle_size);
  const double common_fill = fill(small.size + large.size, m.common_rectangle_size);
  const double hull_gain = (m.common_hull_size - small.hull_size - large.hull_size) /
                           std::max(small.size + large.size, 1e-3);
  const double rectangle_gain =
      (m.common_rectangle_size - small.rectangle_size - large.rectangle_size) /
      std::max(small.size, 0.05);
  return -2.30696 * width_ratio - 2.36355 * narrowness * narrowness +
         2.42162 * logAtLeast(large.clearance, 0.1) + 0.90383 * elongation(small) -
         0.56584 * elongation(small) * elongation(large) -
         4.58537 * (common_fill - std::max(small_fill, large_fill)) -
         2.85192 * (common_fill - std::min(small_fill, large_fill)) -
         3.34000 * std::min(small_fill, 1.1) - 4.47731 * std::clamp(hull_gain, -0.2, 1.5) +
         0.44774 * std::log1p(std::clamp(rectangle_gain, -0.8, 10.));
}

}  // namespace

double separation(const BorderMeasures& m) {
  constexpr double kBias = 6.25345;
  const double width = std::max(m.widest->width, 0.05);
  const double score = kBias + openingTerms(m, width) + wallTerms(m, width) + shapeTerms(m, width) -
                       1.17063 * std::log(static_cast<double>(m.smaller_neighbours)) -
                       0.31788 * std::log(static_cast<double>(m.larger_neighbours));
  return 1 / (1 + std::exp(-std::clamp(score, -30., 30.)));
}

}  // namespace agrid
