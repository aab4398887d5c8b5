// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "planning/ground.h"
#include "tools/pairs_file.h"

namespace agrid::bench {

/// A map to measure: files in map_server form, and the pairs that are asked for.
struct Subject {
  std::string name;
  std::string yaml;
  std::string image;
  std::string pairs;  ///< CSV; empty: pairs are drawn
};

/// Every map that has pairs in `shared`/bench/planning_pairs, by name.
/// @throws std::runtime_error if there are none
std::vector<Subject> mapsWithPairs(const std::string& shared);

/// A generated office of `size` pixels a side, seed 7, 0.05 m a pixel; made in `directory` with the
/// generator of `shared` unless it is there already.
/// @throws std::runtime_error if the generator fails
Subject generatedOffice(const std::string& shared, const std::string& directory, int size);

/// Pairs of free pixels of one component: half of them at any distance, half of them near each
/// other, from 50 pixels up, all orders of magnitude alike. The same ones for the same seed.
std::vector<tools::Pair> drawPairs(const Ground& ground, int count, std::uint32_t seed);

/// Pairs of free pixels of different components; none if there is but one.
std::vector<tools::Pair> drawSeparatedPairs(const Ground& ground, int count, std::uint32_t seed);

}  // namespace agrid::bench
