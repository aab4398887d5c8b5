// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tools/case_scores.h"

namespace agrid::tools {

/// A line for each door of each map as it is given: what is known of it and whether it is true.
std::string doorsCsv(const std::vector<CaseScores>& scores);

/// How often doors are true by how confident we were, over all maps, in the form of Markdown.
std::string reliabilityTable(const std::vector<CaseScores>& scores);

}  // namespace agrid::tools
