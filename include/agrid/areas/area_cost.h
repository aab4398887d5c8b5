// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/areas/area_map.h"
#include "agrid/tags/tag.h"

namespace agrid {

/// What a metre in an area counts, by its property `cost`: a number from 0.001 to 1000 (1: as
/// anywhere; more: to be avoided; less: preferred), or infinity for `forbidden` or `inf`. 1 where
/// there is none or a bad one.
double areaCost(const Properties& properties);

/// What is wrong with the property `cost`, naming value and bounds; empty if nothing is.
std::string costProblem(const Properties& properties);

/// A sentence for each area whose property `cost` is bad, in the order of the areas.
std::vector<std::string> costWarnings(const std::vector<Area>& areas);

}  // namespace agrid
