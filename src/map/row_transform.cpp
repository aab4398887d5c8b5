// SPDX-License-Identifier: BSD-3-Clause
#include "map/row_transform.h"

#include <algorithm>

#include <opencv2/core/hal/intrin.hpp>

namespace agrid {
namespace {

constexpr int kBlock = 16;   ///< pixels that are searched for at once
constexpr int kReach = 180;  ///< how far on either side
constexpr int kStride = 4;   ///< columns between two looks at whether more is to be found
static_assert(kReach % kStride == 0, "no column beyond the reach is looked at");
/// Stands for all greater distances; sums of squares end at the largest 16-bit number.
constexpr int kTooFar = 181;
static_assert(kReach < kTooFar && kTooFar * kTooFar <= 0x7fff,
              "must not pass for one within reach");

}  // namespace

void Envelope::clear(std::int64_t length) {
  count_ = 0;
  length_ = length;
}

void Envelope::add(std::int64_t x, std::int64_t g) {
  const std::int64_t f = x * x + g * g;
  std::int64_t from = 0;
  while (count_ > 0) {
    const Parabola& last = parabolas_[count_ - 1];
    const std::int64_t rise = f - last.f;
    const std::int64_t twice_gap = 2 * (x - last.x);
    if (rise >= last.from * twice_gap) {
      from = rise / twice_gap + 1;
      break;
    }
    --count_;
  }
  if (from < length_) parabolas_[count_++] = {x, f, from};
}

void Envelope::write(std::int64_t begin, std::int64_t end, std::int32_t* out) const {
  if (count_ == 0) std::fill(out, out + (end - begin), kFarSquared);
  std::size_t k = 0;
  for (std::int64_t x = begin; x < end && count_ > 0; ++x) {
    while (k + 1 < count_ && parabolas_[k + 1].from <= x) ++k;
    const std::int64_t value = parabolas_[k].f + x * (x - 2 * parabolas_[k].x);
    *out++ = static_cast<std::int32_t>(std::min<std::int64_t>(value, kFarSquared));
  }
}

RowTransform::RowTransform(int width, Surroundings surroundings)
    : width_(width),
      walled_(surroundings == Surroundings::kMarked),
      envelope_(static_cast<std::size_t>(width)),
      squares_(static_cast<std::size_t>(width + 2 * kReach + kBlock),
               static_cast<std::int16_t>(walled_ ? 0 : kTooFar * kTooFar)),
      squared_(static_cast<std::size_t>(width + kBlock)) {}

const std::int32_t* RowTransform::operator()(const std::uint16_t* column_distance) {
  std::transform(column_distance, column_distance + width_, squares_.begin() + kReach,
                 [](std::uint16_t distance) {
                   const auto d = std::min<std::uint16_t>(distance, kTooFar);
                   return static_cast<std::int16_t>(d * d);
                 });
  int done = 0;  // the pixels before this one have their distances
  for (int begin = 0; begin < width_; begin += kBlock) {
    const int end = std::min(begin + kBlock, width_);
    if (end <= done || searchBlock(begin)) continue;
    for (int x = begin; x < end;) {
      const bool is_far = squared_[static_cast<std::size_t>(x)] > kReach * kReach;
      x = is_far ? done = cross(column_distance, x) : x + 1;
    }
  }
  return squared_.data();
}

/// Fills a block with the distances to what is marked within reach; the others come out greater
/// than the reach. Returns whether there are none.
bool RowTransform::searchBlock(int begin) {
  using cv::v_int16x8;
  const std::int16_t* center = squares_.data() + kReach + begin;
  // their sums saturate
  v_int16x8 low = cv::v_load(center);
  v_int16x8 high = cv::v_load(center + 8);
  const auto isAnyAbove = [&](int limit) {
    return cv::v_check_any(cv::v_max(low, high) > cv::v_setall_s16(static_cast<short>(limit)));
  };
  int dx = 0;  // whose columns and all nearer ones have been looked at
  while (dx < kReach && isAnyAbove((dx + 1) * (dx + 1))) {
    for (const int last = dx + kStride; dx < last;) {
      ++dx;
      const v_int16x8 step = cv::v_setall_s16(static_cast<short>(dx * dx));
      low = cv::v_min(low, cv::v_min(cv::v_load(center - dx), cv::v_load(center + dx)) + step);
      high = cv::v_min(high,
                       cv::v_min(cv::v_load(center + 8 - dx), cv::v_load(center + 8 + dx)) + step);
    }
  }
  std::int32_t* out = squared_.data() + begin;
  for (const v_int16x8& eight : {low, high}) {
    cv::v_int32x4 first;
    cv::v_int32x4 second;
    cv::v_expand(eight, first, second);
    cv::v_store(out, first);
    cv::v_store(out + 4, second);
    out += 8;
  }
  return !isAnyAbove(kReach * kReach);
}

/// Fills the stretch around `x` between two marked pixels, which hide what lies beyond them.
/// Returns its end.
int RowTransform::cross(const std::uint16_t* column_distance, int x) {
  int begin = x;
  int end = x + 1;
  while (begin > 0 && column_distance[begin - 1] != 0) --begin;
  while (end < width_ && column_distance[end] != 0) ++end;
  const int origin = begin - 1;
  envelope_.clear(end - origin);
  if (begin > 0 || walled_) envelope_.add(0, 0);
  for (int i = begin; i < end; ++i) {
    if (column_distance[i] < kFarInColumn) envelope_.add(i - origin, column_distance[i]);
  }
  if (end < width_ || walled_) envelope_.add(end - origin, 0);
  envelope_.write(1, end - origin, squared_.data() + begin);
  return end;
}

}  // namespace agrid
