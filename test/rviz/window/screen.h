// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include <sys/types.h>

namespace agrid_map_rviz::test {

/// An X server without a screen, drawn by the processor, and a home folder of its own, as long as
/// this object lives. Made before Qt starts.
class Screen {
 public:
  /// @throws std::runtime_error if the server does not come up
  Screen();
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

 private:
  pid_t server_ = -1;
  std::string folder_;
};

}  // namespace agrid_map_rviz::test
