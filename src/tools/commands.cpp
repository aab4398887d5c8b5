// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands.h"

#include <iostream>

namespace agrid::tools {

int run(const std::vector<std::string>&) {
  std::cerr << "usage: agrid_map_tool COMMAND\n";
  return 64;
}

}  // namespace agrid::tools
