// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "tools/case_scores.h"

namespace agrid::tools {

/// Scores maps, `threads` at a time; the result does not depend on it. Tells how many are done on
/// standard error where that is a terminal.
/// @return in the order of the cases
/// @throws what scoreCase throws for the first of those that failed
std::vector<CaseScores> scoreCases(const std::vector<EvalCase>& cases,
                                   const ConversionParams& params, const std::vector<View>& views,
                                   int threads);

}  // namespace agrid::tools
