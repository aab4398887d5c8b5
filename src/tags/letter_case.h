// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace agrid {

/// A capital's small letter (Unicode 14, simple case folding, of the scripts that `foldCase`
/// names); any other character as it is.
char32_t smallLetter(char32_t c);

}  // namespace agrid
