// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace agrid {

/// The text with control characters and bytes that are not UTF-8 written as \xNN, fit for a log.
std::string printable(const std::string& text);

}  // namespace agrid
