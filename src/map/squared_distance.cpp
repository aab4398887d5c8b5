// SPDX-License-Identifier: BSD-3-Clause
#include "map/squared_distance.h"

#include <algorithm>
#include <limits>

namespace agrid {
namespace {

constexpr std::int64_t kNone = std::numeric_limits<std::int32_t>::max();

struct Progress {
  const std::function<void()>& between_rows;
  void row(std::size_t y) const {
    if (y % 64 == 0 && between_rows) between_rows();
  }
};

/// Distance to the nearest marked pixel of the same column, row by row so that memory is read in
/// order; kNone if the column has none.
std::vector<std::int32_t> columnDistances(const MapGeometry& geometry,
                                          const std::vector<std::uint8_t>& marked,
                                          const Progress& progress) {
  const auto width = static_cast<std::size_t>(geometry.width);
  const auto height = static_cast<std::size_t>(geometry.height);
  constexpr auto kNoDistance = static_cast<std::int32_t>(kNone);
  std::vector<std::int32_t> distance(geometry.pixelCount());
  for (std::size_t y = 0; y < height; ++y) {
    progress.row(y);
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      const std::int32_t above = y == 0 ? kNoDistance : distance[i - width];
      distance[i] = marked[i] != 0 ? 0 : above == kNoDistance ? kNoDistance : above + 1;
    }
  }
  for (std::size_t y = height - 1; y-- > 0;) {
    progress.row(y);
    for (std::size_t i = y * width; i < (y + 1) * width; ++i) {
      const std::int32_t below = distance[i + width];
      if (below != kNoDistance) distance[i] = std::min(distance[i], below + 1);
    }
  }
  return distance;
}

/// The lower envelope of one row's parabolas (x - i)^2 + distance(i)^2.
class Envelope {
 public:
  explicit Envelope(std::size_t width) : apex_(width), from_(width) {}

  void transform(std::int32_t* row, std::int64_t width) {
    collect(row, width);
    std::copy(row, row + width, distance_.begin());
    std::size_t q = count_;
    for (std::int64_t x = width - 1; x >= 0; --x) {
      if (count_ == 0) {
        row[x] = kFarSquared;
        continue;
      }
      while (q > 1 && from_[q - 1] > x) --q;
      const std::int64_t value = at(x, apex_[q - 1]);
      row[x] = static_cast<std::int32_t>(std::min<std::int64_t>(value, kFarSquared));
    }
  }

 private:
  void collect(const std::int32_t* row, std::int64_t width) {
    distance_.assign(row, row + width);
    count_ = 0;
    for (std::int64_t x = 0; x < width; ++x) {
      if (row[x] == kNone) continue;
      while (count_ > 0 && at(from_[count_ - 1], apex_[count_ - 1]) > at(from_[count_ - 1], x)) {
        --count_;
      }
      const std::int64_t from = count_ == 0 ? 0 : takesOver(apex_[count_ - 1], x);
      if (from >= width) continue;
      apex_[count_] = x;
      from_[count_++] = from;
    }
  }

  std::int64_t at(std::int64_t x, std::int64_t apex) const {
    const std::int64_t d = distance_[static_cast<std::size_t>(apex)];
    return (x - apex) * (x - apex) + d * d;
  }

  /// The first pixel where the parabola of `right` lies below that of `left`.
  std::int64_t takesOver(std::int64_t left, std::int64_t right) const {
    const std::int64_t a = distance_[static_cast<std::size_t>(left)];
    const std::int64_t b = distance_[static_cast<std::size_t>(right)];
    const std::int64_t numerator = right * right - left * left + b * b - a * a;
    const std::int64_t denominator = 2 * (right - left);
    const std::int64_t floor = numerator / denominator - (numerator % denominator < 0 ? 1 : 0);
    return floor + 1;
  }

  std::vector<std::int64_t> apex_;
  std::vector<std::int64_t> from_;
  std::vector<std::int32_t> distance_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<std::int32_t> squaredDistances(const MapGeometry& geometry,
                                           const std::vector<std::uint8_t>& marked,
                                           const std::function<void()>& between_rows) {
  const Progress progress{between_rows};
  std::vector<std::int32_t> result = columnDistances(geometry, marked, progress);
  const auto width = static_cast<std::size_t>(geometry.width);
  Envelope envelope(width);
  for (std::size_t y = 0; y < static_cast<std::size_t>(geometry.height); ++y) {
    progress.row(y);
    envelope.transform(result.data() + y * width, geometry.width);
  }
  return result;
}

}  // namespace agrid
