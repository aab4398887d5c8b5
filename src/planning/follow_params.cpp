// SPDX-License-Identifier: BSD-3-Clause
#include "agrid/planning/lead_follower.h"

namespace agrid {
namespace {

std::string problem(const char* field, double value, const char* bounds) {
  return std::string(field) + " = " + std::to_string(value) + " must be " + bounds;
}

bool isIn(double value, double low, double high) {
  return value >= low && value <= high;  // false for NaN
}

}  // namespace

std::string problemOf(const FollowParams& params) {
  const CostRules& rules = params.rules;
  if (!isIn(rules.neutral_cost, 1, 1000)) {
    return problem("neutral_cost", rules.neutral_cost, "from 1 to 1000");
  }
  if (!isIn(rules.cost_factor, 0, 1000)) {
    return problem("cost_factor", rules.cost_factor, "from 0 to 1000");
  }
  if (!isIn(rules.lethal_cost, 1, 254)) {
    return problem("lethal_cost", rules.lethal_cost, "from 1 to 254");
  }
  if (!isIn(params.band, 0.05, 100)) return problem("band", params.band, "from 0.05 to 100 m");
  if (!isIn(params.detour, 0, 1000)) return problem("detour", params.detour, "from 0 to 1000 m");
  if (!isIn(params.max_leads, 0, 100)) {
    return problem("max_leads", params.max_leads, "from 0 to 100");
  }
  return {};
}

}  // namespace agrid
