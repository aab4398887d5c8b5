// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <random>

namespace agrid {

/// Random integers that are the same on every machine: the standard fixes the engine, but not its
/// distributions. Draw into variables, one statement each: the order in which arguments are
/// evaluated differs between compilers.
class RandomSource {
 public:
  explicit RandomSource(std::uint32_t seed) : engine_(seed) {}

  /// A number in [low, high]; low if the range is empty.
  int between(int low, int high) {
    const std::uint64_t draw = engine_();
    if (high <= low) return low;
    const auto span = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
    return static_cast<int>(low + static_cast<std::int64_t>((draw * span) >> 32U));
  }
  /// True in `percent` of 100 cases.
  bool chance(int percent) { return between(0, 99) < percent; }

 private:
  std::mt19937 engine_;
};

}  // namespace agrid
