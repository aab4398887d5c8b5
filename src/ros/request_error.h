// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>

#include <agrid_map/Status.h>

namespace agrid_map_ros {

/// A request that cannot be answered; becomes the Status of the response.
class RequestError : public std::runtime_error {
 public:
  /// @param code  a constant of agrid_map/Status
  RequestError(std::uint8_t code, const std::string& message)
      : std::runtime_error(message), code_(code) {}
  std::uint8_t code() const { return code_; }

 private:
  std::uint8_t code_;
};

/// What the exception that is being handled means to the client: every one ends here.
agrid_map::Status statusOfException();
/// Whether that exception refuses a request, a map or a file; any other is a mistake of ours or of
/// a library.
bool isRefusal();

}  // namespace agrid_map_ros
