// SPDX-License-Identifier: BSD-3-Clause
#include "ros/request_error.h"

#include <new>

#include <XmlRpcException.h>
#include <boost/exception/diagnostic_information.hpp>

#include "agrid/map/map_io.h"
#include "agrid/pipeline/edit.h"
#include "agrid/semantic_map/thing_lookup.h"
#include "agrid/storage.h"
#include "agrid_map_ros/conversions.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

std::uint8_t codeOf(agrid::LookupErrorCode code) {
  return code == agrid::LookupErrorCode::kUnknownName ? Status::UNKNOWN_NAME
                                                      : Status::INVALID_REQUEST;
}

std::uint8_t codeOf(agrid::EditErrorCode code) {
  switch (code) {
    case agrid::EditErrorCode::kInvalid:
      break;
    case agrid::EditErrorCode::kUnknownName:
      return Status::UNKNOWN_NAME;
    case agrid::EditErrorCode::kNameTaken:
      return Status::NAME_TAKEN;
    case agrid::EditErrorCode::kOutside:
      return Status::OUTSIDE;
    case agrid::EditErrorCode::kLimit:
      return Status::LIMIT_REACHED;
  }
  return Status::INVALID_REQUEST;
}

/// A name that may not name a file is the client's mistake, all else is not.
std::uint8_t codeOf(agrid::StorageErrorCode code) {
  return code == agrid::StorageErrorCode::kPath ? Status::INVALID_REQUEST : Status::STORAGE_FAILED;
}

}  // namespace

Status statusOfException() {
  try {
    throw;
  } catch (const RequestError& error) {
    return statusOf(error.code(), error.what());
  } catch (const agrid::LookupError& error) {
    return statusOf(codeOf(error.code()), error.what());
  } catch (const agrid::EditError& error) {
    return statusOf(codeOf(error.code()), printable(error.what()));
  } catch (const agrid::StorageError& error) {
    return statusOf(codeOf(error.code()), printable(error.what()));
  } catch (const std::bad_alloc&) {
    return statusOf(Status::LIMIT_REACHED, "out of memory");
  } catch (const XmlRpc::XmlRpcException& error) {  // no std::exception
    return statusOf(Status::INVALID_REQUEST, printable(error.getMessage()));
  } catch (const std::exception& error) {
    return statusOf(Status::INVALID_REQUEST, printable(error.what()));
  } catch (...) {
    return statusOf(Status::INVALID_REQUEST,
                    printable(boost::current_exception_diagnostic_information()));
  }
}

bool isRefusal() {
  try {
    throw;
  } catch (const RequestError&) {
  } catch (const agrid::LookupError&) {
  } catch (const agrid::EditError&) {
  } catch (const agrid::StorageError&) {
  } catch (const agrid::MapError&) {
  } catch (const agrid::FileError&) {
  } catch (const std::invalid_argument&) {  // what the core says of a request's values
  } catch (...) {
    return false;
  }
  return true;
}

}  // namespace agrid_map_ros
