// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace agrid {

/// Why a text cannot be the name, alias or category of a thing, a sentence without a full stop that
/// shows the text (its beginning, if it is long); empty if it can. A name has 1 to 256 bytes of
/// UTF-8, no control characters, line breaks or characters that change the direction of what
/// follows (U+202A to U+202E, U+2066 to U+2069), and something in it that can be seen.
std::string problemOfName(const std::string& name);

/// The text with capitals as small letters: Unicode's simple case folding for the Latin, Greek,
/// Cyrillic, Armenian and full-width letters, everything else as it is, whatever the process's
/// locale. Bytes that are not UTF-8 stay, and then only ASCII letters are folded.
std::string foldCase(const std::string& text);

}  // namespace agrid
