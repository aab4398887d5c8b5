// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "storage/stored_node.h"

namespace agrid {

/// Text as a double-quoted YAML scalar in one line; bytes that are not UTF-8 as !!binary. What any
/// YAML reader makes of it is the text, byte for byte.
std::string quoted(const std::string& text);

/// The shortest decimal number that reads back as the same double, whatever the locale is.
std::string numberText(double number);

/// A double written in full and in the classic locale: no nan, no inf, no spaces.
std::optional<double> numberOf(const std::string& text);

/// Reads one value in YAML's flow style, as far as this package writes it (quoted(), numbers and
/// words, `[a, b]`, `{key: a, key: b}`), several times as fast as yaml-cpp.
/// @param line  of the nodes
/// @return none if the text is anything else, be it YAML or not
std::optional<StoredNode> parseFlow(std::string_view text, int line);

}  // namespace agrid
