// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <fstream>
#include <string>

namespace agrid::test {

/// How far the peak resident memory of this process has risen since construction (Linux); 0 under
/// AddressSanitizer, whose own memory would be counted.
class MemoryGrowth {
 public:
  MemoryGrowth() {
    std::ofstream("/proc/self/clear_refs") << 5;  // sets the peak back to what is in use now
    before_ = peak();
  }
  std::size_t bytes() const {
#ifdef __SANITIZE_ADDRESS__
    return 0;
#endif
    const std::size_t now = peak();
    return now > before_ ? now - before_ : 0;
  }

 private:
  static std::size_t peak() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);) {
      if (line.rfind("VmHWM:", 0) == 0) return std::stoul(line.substr(6)) * 1024;
    }
    return 0;
  }

  std::size_t before_ = 0;
};

}  // namespace agrid::test
