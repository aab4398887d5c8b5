// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tools/case_scores.h"

namespace agrid::tools {

/// A table for each group of maps, in the form of Markdown: a row for each map as it is given, and
/// their mean.
std::string scoreTables(const std::vector<CaseScores>& scores);

/// The mean MCC of each group in each view, and how it differs from that of the maps as given.
std::string robustnessTable(const std::vector<CaseScores>& scores, const std::vector<View>& views);

/// Everything: a line for each map and view.
std::string scoresCsv(const std::vector<CaseScores>& scores, const std::vector<View>& views);

}  // namespace agrid::tools
