// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "map/squared_distance.h"

namespace agrid {

/// Distances along a column from which on the squares exceed kFarSquared, or there is none.
constexpr std::uint16_t kFarInColumn = 46341;

/// The lower envelope of the parabolas (x - i)^2 + g(i)^2 of a stretch of a row.
class Envelope {
 public:
  explicit Envelope(std::size_t width) : parabolas_(width + 2) {}
  /// Starts anew; positions count from 0 to below `length`.
  void clear(std::int64_t length);
  /// Adds a parabola to the right of those before.
  void add(std::int64_t x, std::int64_t g);
  /// Writes the envelope from position `begin` to below `end` to `out`.
  void write(std::int64_t begin, std::int64_t end, std::int32_t* out) const;

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

/// From the distances along the columns to those in the plane, a row at a time. Where marked pixels
/// are near, as they mostly are, it tries all of a block's neighbours at once, which modern
/// processors do faster than anything that decides; where they are far, it takes the envelope.
class RowTransform {
 public:
  RowTransform(int width, Surroundings surroundings);

  /// @param column_distance  of each pixel of the row, at most kFarInColumn
  /// @return the squared distances of its pixels, until the next call
  const std::int32_t* operator()(const std::uint16_t* column_distance);

 private:
  bool searchBlock(int x);
  int cross(const std::uint16_t* column_distance, int x);

  int width_;
  bool walled_;
  Envelope envelope_;
  std::vector<std::int16_t> squares_;  ///< of the column distances; padded
  std::vector<std::int32_t> squared_;
};

}  // namespace agrid
