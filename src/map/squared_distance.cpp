// SPDX-License-Identifier: BSD-3-Clause
#include "map/squared_distance.h"

#include <algorithm>
#include <cstddef>

namespace agrid {
namespace {

/// Distances along a column from which on the squares exceed kFarSquared, or there is none.
constexpr std::uint16_t kFar = 46341;

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

/// The lower envelope of the parabolas (x - i)^2 + g(i)^2 of a stretch of a row.
class Envelope {
 public:
  explicit Envelope(std::size_t width) : parabolas_(width + 2) {}

  /// Starts anew; positions count from 0 to below `length`.
  void clear(std::int64_t length) {
    count_ = 0;
    length_ = length;
  }

  /// Adds a parabola to the right of those before.
  void add(std::int64_t x, std::int64_t g) {
    const std::int64_t f = x * x + g * g;
    std::int64_t from = 0;
    while (count_ > 0) {
      const Parabola& last = parabolas_[count_ - 1];
      const std::int64_t rise = f - last.f;
      const std::int64_t twice_gap = 2 * (x - last.x);
      if (rise >= last.from * twice_gap) {
        // 32 bits are divided several times faster
        from = 1 + (rise <= UINT32_MAX
                        ? static_cast<std::uint32_t>(rise) / static_cast<std::uint32_t>(twice_gap)
                        : rise / twice_gap);
        break;
      }
      --count_;
    }
    if (from < length_) parabolas_[count_++] = {x, f, from};
  }

  /// Writes the envelope from position `begin` to below `end` to `out`.
  void write(std::int64_t begin, std::int64_t end, std::int32_t* out) const {
    if (count_ == 0) std::fill(out, out + (end - begin), kFarSquared);
    std::size_t k = 0;
    for (std::int64_t x = begin; x < end && count_ > 0; ++x) {
      while (k + 1 < count_ && parabolas_[k + 1].from <= x) ++k;
      const std::int64_t value = parabolas_[k].f + x * (x - 2 * parabolas_[k].x);
      *out++ = static_cast<std::int32_t>(std::min<std::int64_t>(value, kFarSquared));
    }
  }

 private:
  struct Parabola {
    std::int64_t x;     ///< of its apex
    std::int64_t f;     ///< its value at 0
    std::int64_t from;  ///< where it becomes the lowest
  };
  std::vector<Parabola> parabolas_;
  std::size_t count_ = 0;
  std::int64_t length_ = 0;
};

/// From the distances along the columns to those in the plane, a row at a time. A marked pixel
/// hides what lies beyond it, so that each stretch between two of them is a problem of its own.
class RowTransform {
 public:
  RowTransform(int width, Surroundings surroundings)
      : width_(width),
        walled_(surroundings == Surroundings::kMarked),
        envelope_(static_cast<std::size_t>(width)),
        squared_(static_cast<std::size_t>(width)) {}

  const std::int32_t* operator()(const std::uint16_t* column_distance) {
    for (int x = 0; x < width_;) {
      if (column_distance[x] == 0) {
        squared_[static_cast<std::size_t>(x++)] = 0;
        continue;
      }
      const int begin = x;
      while (x < width_ && column_distance[x] != 0) ++x;
      cross(column_distance, begin, x);
    }
    return squared_.data();
  }

 private:
  /// Fills the unmarked stretch from `begin` to below `end`.
  void cross(const std::uint16_t* column_distance, int begin, int end) {
    const int origin = begin - 1;
    envelope_.clear(end - origin);
    if (begin > 0 || walled_) envelope_.add(0, 0);
    for (int x = begin; x < end; ++x) {
      if (column_distance[x] < kFar) envelope_.add(x - origin, column_distance[x]);
    }
    if (end < width_ || walled_) envelope_.add(end - origin, 0);
    envelope_.write(1, end - origin, squared_.data() + begin);
  }

  int width_;
  bool walled_;
  Envelope envelope_;
  std::vector<std::int32_t> squared_;
};

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
