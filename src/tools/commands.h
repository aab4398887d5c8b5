// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace agrid::tools {

/// Runs the command line tool.
/// @param arguments  as main's, the program's name first
/// @return the exit code: 0 done, 1 failed, 2 a file cannot be read or written, 64 wrong usage
int run(const std::vector<std::string>& arguments);

}  // namespace agrid::tools
