// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace agrid {

/// The fewest insertions, deletions and replacements of characters that turn `a` into `b`
/// (Levenshtein 1966; the table by rows, Wagner and Fischer 1974). Of a text that is not UTF-8,
/// bytes are characters.
std::size_t editDistance(const std::string& a, const std::string& b);

/// Up to `count` names nearest to `wanted` without regard to case, the nearest first.
std::vector<std::string> closestNames(const std::string& wanted,
                                      const std::vector<std::string>& names, std::size_t count = 3);

/// The names joined by commas.
std::string joined(const std::vector<std::string>& names);

}  // namespace agrid
