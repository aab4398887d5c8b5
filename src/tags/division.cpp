// SPDX-License-Identifier: BSD-3-Clause
#include "tags/division.h"

#include "tags/persistence.h"

namespace agrid {

Division divide(const Relief& relief, double resolution, const AreaParams& params) {
  if (params.method == AreaMethod::kPaper) return {};
  Division division;
  division.basins = findBasins(relief.height);
  division.area_of = mergeByPersistence(division.basins, resolution, params);
  return division;
}

}  // namespace agrid
