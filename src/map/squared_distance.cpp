// SPDX-License-Identifier: BSD-3-Clause
#include "map/squared_distance.h"

#include <algorithm>
#include <cstddef>

#include "map/row_transform.h"

namespace agrid {
namespace {

constexpr std::uint16_t kFar = kFarInColumn;

/// For each pixel the distance to the nearest marked pixel above it, at most kFar; row by row so
/// that memory is read in order.
std::vector<std::uint16_t> distancesFromAbove(const MapGeometry& geometry,
                                              const std::uint8_t* marked,
                                              Surroundings surroundings) {
  const auto width = static_cast<std::size_t>(geometry.width);
  std::vector<std::uint16_t> distance(geometry.pixelCount());
  const std::uint16_t beyond = surroundings == Surroundings::kMarked ? 0 : kFar;
  std::vector<std::uint16_t> previous(width, beyond);
  const std::uint16_t* above = previous.data();
  for (std::size_t begin = 0; begin < distance.size(); begin += width) {
    std::uint16_t* row = distance.data() + begin;
    for (std::size_t x = 0; x < width; ++x) {
      const auto next = static_cast<std::uint16_t>(above[x] + (above[x] < kFar ? 1 : 0));
      row[x] = marked[begin + x] != 0 ? std::uint16_t{0} : next;
    }
    above = row;
  }
  return distance;
}

}  // namespace

void forEachRowOfSquaredDistances(
    const MapGeometry& geometry, const std::uint8_t* marked, Surroundings surroundings,
    const std::function<void(int y, const std::int32_t* squared)>& take_row) {
  const auto width = static_cast<std::size_t>(geometry.width);
  std::vector<std::uint16_t> distance = distancesFromAbove(geometry, marked, surroundings);
  RowTransform transform(geometry.width, surroundings);
  const std::uint16_t beyond = surroundings == Surroundings::kMarked ? 0 : kFar;
  const std::vector<std::uint16_t> next(width, beyond);
  const std::uint16_t* below = next.data();
  for (int y = geometry.height - 1; y >= 0; --y) {
    std::uint16_t* row = distance.data() + static_cast<std::size_t>(y) * width;
    for (std::size_t x = 0; x < width; ++x) {
      row[x] = std::min(row[x], static_cast<std::uint16_t>(below[x] + 1));
    }
    take_row(y, transform(row));
    below = row;
  }
}

std::vector<std::int32_t> squaredDistances(const MapGeometry& geometry,
                                           const std::vector<std::uint8_t>& marked,
                                           const std::function<void()>& between_rows) {
  const auto width = static_cast<std::size_t>(geometry.width);
  std::vector<std::int32_t> result(geometry.pixelCount());
  forEachRowOfSquaredDistances(
      geometry, marked.data(), Surroundings::kUnmarked, [&](int y, const std::int32_t* squared) {
        if (y % 64 == 0 && between_rows) between_rows();
        std::copy(squared, squared + width, result.data() + static_cast<std::size_t>(y) * width);
      });
  return result;
}

}  // namespace agrid
