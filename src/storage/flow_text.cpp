// SPDX-License-Identifier: BSD-3-Clause
#include "storage/flow_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <yaml-cpp/binary.h>

#include "map/utf8.h"

namespace agrid {
namespace {

constexpr int kDeepest = 8;
constexpr std::string_view kBinary = "!!binary ";

// U+0080 to U+009F and U+2028, U+2029 end lines for some readers, U+FEFF and the marks of direction
// are invisible.
bool needsEscape(char32_t c) {
  return c < 0x20 || (c >= 0x7F && c < 0xA0) || (c >= 0x200B && c <= 0x200F) ||
         (c >= 0x2028 && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) || c == 0xFEFF ||
         c == 0xFFFE || c == 0xFFFF;
}

std::string escaped(char32_t c) {
  constexpr const char* kDigits = "0123456789ABCDEF";
  std::string text = c < 0x100 ? "\\x" : "\\u";
  for (int shift = c < 0x100 ? 4 : 12; shift >= 0; shift -= 4) text += kDigits[(c >> shift) & 15];
  return text;
}

/// Reads from the front of a text.
class FlowReader {
 public:
  FlowReader(std::string_view text, int line) : text_(text), line_(line) {}

  bool atEnd() const { return next_ == text_.size(); }

  std::optional<StoredNode> value(int depth) {
    if (depth > kDeepest || atEnd()) return std::nullopt;
    if (text_[next_] == '{' || text_[next_] == '[') return collection(depth);
    StoredNode node;
    node.kind = StoredNode::Kind::kScalar;
    node.line = line_;
    auto text = scalar();
    if (!text) return std::nullopt;
    node.text = std::move(*text);
    return node;
  }

 private:
  bool take(std::string_view expected) {
    if (text_.substr(next_, expected.size()) != expected) return false;
    next_ += expected.size();
    return true;
  }

  std::optional<StoredNode> collection(int depth) {
    const bool is_mapping = text_[next_++] == '{';
    const std::string_view end = is_mapping ? "}" : "]";
    StoredNode node;
    node.kind = is_mapping ? StoredNode::Kind::kMapping : StoredNode::Kind::kSequence;
    node.line = line_;
    if (take(end)) return node;
    do {
      std::optional<std::string> key;
      if (is_mapping && (!(key = scalar()) || !take(": "))) return std::nullopt;
      auto child = value(depth + 1);
      if (!child) return std::nullopt;
      if (key) child->key = std::move(*key);
      if (key && holds(node, child->key)) return std::nullopt;
      node.children.push_back(std::move(*child));
    } while (take(", "));
    if (!take(end)) return std::nullopt;
    return node;
  }

  std::optional<std::string> scalar() {
    if (atEnd()) return std::nullopt;
    if (text_[next_] == '"') return quotedText();
    if (take(kBinary)) {
      const auto encoded = quotedText();
      if (!encoded) return std::nullopt;
      const auto bytes = YAML::DecodeBase64(*encoded);
      if (bytes.empty()) return std::nullopt;
      return std::string(bytes.begin(), bytes.end());
    }
    const std::size_t start = next_;
    while (!atEnd() && isPlain(text_[next_])) ++next_;
    const std::string_view word = text_.substr(start, next_ - start);
    // words that are something else in YAML
    if (word.empty() || word == "null" || word == "-") return std::nullopt;
    return std::string(word);
  }

  static bool holds(const StoredNode& mapping, const std::string& key) {
    return std::any_of(mapping.children.begin(), mapping.children.end(),
                       [&](const StoredNode& child) { return child.key == key; });
  }

  static bool isPlain(char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || c == '.' || c == '-' || c == '+' ||
           c == '_';
  }

  std::optional<std::string> quotedText() {
    if (!take("\"")) return std::nullopt;
    std::string result;
    for (;;) {
      const std::size_t stop = text_.find_first_of("\"\\", next_);
      if (stop == std::string_view::npos) return std::nullopt;
      result.append(text_, next_, stop - next_);
      next_ = stop + 1;
      if (text_[stop] == '"') return result;
      if (!unescape(result)) return std::nullopt;
    }
  }

  bool unescape(std::string& result) {
    if (atEnd()) return false;
    const char kind = text_[next_++];
    if (kind == '"' || kind == '\\') {
      result += kind;
      return true;
    }
    const std::size_t digits = kind == 'x' ? 2 : kind == 'u' ? 4 : 0;
    if (digits == 0 || text_.size() - next_ < digits) return false;
    std::uint32_t code = 0;
    const char* first = text_.data() + next_;
    const auto [end, error] = std::from_chars(first, first + digits, code, 16);
    if (error != std::errc() || end != first + digits) return false;
    next_ += digits;
    appendUtf8(result, code);
    return true;
  }

  std::string_view text_;
  std::size_t next_ = 0;
  int line_;
};

}  // namespace

std::string quoted(const std::string& text) {
  const auto code_points = codePointsOf(text);
  if (!code_points) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(text.data());
    return std::string(kBinary) + '"' + YAML::EncodeBase64(bytes, text.size()) + '"';
  }
  std::string result = "\"";
  for (const char32_t c : *code_points) {
    if (c == '"' || c == '\\') result += '\\';
    if (needsEscape(c)) {
      result += escaped(c);
    } else {
      appendUtf8(result, c);
    }
  }
  return result + '"';
}

std::string numberText(double number) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
  return {text.data(), end};
}

std::optional<double> numberOf(const std::string& text) {
  const std::size_t sign = !text.empty() && text[0] == '+' ? 1 : 0;
  double number = 0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data() + sign, end, number);
  if (read.ec != std::errc() || read.ptr != end || !std::isfinite(number)) return std::nullopt;
  return number;
}

std::optional<StoredNode> parseFlow(std::string_view text, int line) {
  FlowReader reader(text, line);
  auto node = reader.value(0);
  if (!node || !reader.atEnd()) return std::nullopt;
  return node;
}

}  // namespace agrid
