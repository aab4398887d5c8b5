// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "planning/figures.h"

namespace agrid::bench {

/// A Markdown table: a line for each figure, a column for each map.
std::string markdownTable(const std::vector<Figures>& maps);

/// The same as CSV: a line for each map below a header.
std::string csvTable(const std::vector<Figures>& maps);

}  // namespace agrid::bench
