// SPDX-License-Identifier: BSD-3-Clause
#include "ros/request_error.h"

#include <new>

#include "agrid/semantic_map/thing_lookup.h"
#include "agrid_map_ros/conversions.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

std::uint8_t codeOf(agrid::LookupErrorCode code) {
  return code == agrid::LookupErrorCode::kUnknownName ? Status::UNKNOWN_NAME
                                                      : Status::INVALID_REQUEST;
}

}  // namespace

Status statusOfException() {
  try {
    throw;
  } catch (const RequestError& error) {
    return statusOf(error.code(), error.what());
  } catch (const agrid::LookupError& error) {
    return statusOf(codeOf(error.code()), error.what());
  } catch (const std::bad_alloc&) {
    return statusOf(Status::LIMIT_REACHED, "out of memory");
  } catch (const std::exception& error) {
    return statusOf(Status::INVALID_REQUEST, printable(error.what()));
  } catch (...) {
    return statusOf(Status::INVALID_REQUEST, "unknown exception");
  }
}

}  // namespace agrid_map_ros
