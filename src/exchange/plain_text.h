// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "agrid/areas/area_map.h"

namespace agrid {

/// A text that every format can hold: what is not UTF-8, and characters that XML 1.0 forbids, are
/// replaced by U+FFFD; line breaks and tabulators by blanks.
std::string plainText(const std::string& text);

/// A number as text, the same in every locale, to a tenth of a millimetre: finer than any map.
std::string plainNumber(double value);

// The words of the other formats, as in stored tags (doc/file_format.md).
const char* wordOf(DoorKind kind);
const char* wordOf(DoorState state);
const char* wordOf(TagSource source);

}  // namespace agrid
