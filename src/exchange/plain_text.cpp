// SPDX-License-Identifier: BSD-3-Clause
#include "exchange/plain_text.h"

#include <cmath>
#include <locale>
#include <sstream>

#include "map/utf8.h"

namespace agrid {

std::string plainText(const std::string& text) {
  static const std::string kReplacement = "\xEF\xBF\xBD";
  std::string plain;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = sequenceLength(text, i);
    const auto byte = static_cast<unsigned char>(text[i]);
    const std::string sequence = text.substr(i, length);
    if (byte == '\t' || byte == '\n' || byte == '\r') {
      plain += ' ';
    } else if (length == 0 || byte < 0x20 || byte == 0x7F || sequence == "\xEF\xBF\xBE" ||
               sequence == "\xEF\xBF\xBF") {
      plain += kReplacement;
    } else {
      plain += sequence;
    }
    i += length == 0 ? 1 : length;
  }
  return plain;
}

std::string plainNumber(double value) {
  const double rounded = std::round(value * 1e4) / 1e4;
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(15);
  text << (rounded == 0 ? 0.0 : rounded);  // never "-0"
  return text.str();
}

const char* wordOf(DoorKind kind) { return kind == DoorKind::kDoor ? "door" : "passage"; }

const char* wordOf(DoorState state) {
  switch (state) {
    case DoorState::kOpen:
      return "open";
    case DoorState::kClosed:
      return "closed";
    case DoorState::kUnknown:
      break;
  }
  return "unknown";
}

const char* wordOf(TagSource source) {
  switch (source) {
    case TagSource::kManual:
      return "manual";
    case TagSource::kInteraction:
      return "interaction";
    case TagSource::kAutomatic:
      break;
  }
  return "automatic";
}

}  // namespace agrid
