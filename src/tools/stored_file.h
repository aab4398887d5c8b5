// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "agrid/storage.h"

namespace agrid::tools {

/// Reads a file of stored knowledge, with the journals beside it, and tells its warnings and damage
/// on standard error.
/// @throws StorageError
StoreContents readAndWarn(const std::string& path);

/// Prints what was found, a line each.
/// @return the exit code: kDone if there is nothing, kFound, kFileFailed if it cannot be printed
int printFound(const std::vector<std::string>& lines);

}  // namespace agrid::tools
