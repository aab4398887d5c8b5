// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace agrid::tools {

using TableRow = std::vector<std::string>;

/// A number by a format of printf.
std::string formatted(const char* format, double value);

/// Markdown with columns of even width; the first one is text, the others numbers.
/// @param rows  the head first; all of the same length, at least one
std::string markdownTable(const std::vector<TableRow>& rows);

/// A field of a CSV file, in quotes if it needs them.
std::string csvField(const std::string& value);

}  // namespace agrid::tools
