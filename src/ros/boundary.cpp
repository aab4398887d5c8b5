// SPDX-License-Identifier: BSD-3-Clause
#include "ros/boundary.h"

#include "ros/request_error.h"

namespace agrid_map_ros {

agrid_map::Status caught(EventLog& log, const std::string& kind) noexcept {
  try {
    agrid_map::Status status = statusOfException();
    if (!isRefusal()) log.caught(kind, status.message);
    return status;
  } catch (...) {
    // no memory is left to say more
    agrid_map::Status status;
    status.code = agrid_map::Status::LIMIT_REACHED;
    return status;
  }
}

}  // namespace agrid_map_ros
