// SPDX-License-Identifier: BSD-3-Clause
#include "tools/stored_file.h"

#include <iostream>

#include "tools/commands.h"

namespace agrid::tools {

StoreContents readAndWarn(const std::string& path) {
  StoreContents contents = readStoredMap(path);
  for (const std::string& error : contents.errors) std::cerr << "damaged: " << error << "\n";
  for (const std::string& warning : contents.warnings) std::cerr << "warning: " << warning << "\n";
  return contents;
}

int printFound(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) std::cout << line << "\n";
  std::cout.flush();
  if (!std::cout.good()) return kFileFailed;
  return lines.empty() ? kDone : kFound;
}

}  // namespace agrid::tools
