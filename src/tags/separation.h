// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tags/region_graph.h"

namespace agrid {

/// How sure it is that people would draw a border between two regions, in (0, 1): a logistic
/// function of the border's and the regions' geometry, fitted to floor plans whose rooms people
/// have drawn (doc/areas.md says to which and how well). Only ratios of lengths, areas and a few
/// lengths in metres enter, neither direction nor place.
double separation(const BorderMeasures& measures);

}  // namespace agrid
