// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/storage.h"

namespace agrid::tools {

/// What is different in B, a sentence each: about the place, areas, doors, objects, in the order of
/// their ids. Empty if nothing is: lengths below 5 mm, angles below half a degree, outlines of
/// which at least 95 % are common and the seeds of automatic areas do not count, and where frames
/// differ no place is compared.
std::vector<std::string> differences(const StoreContents& a, const StoreContents& b);

}  // namespace agrid::tools
