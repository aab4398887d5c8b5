// SPDX-License-Identifier: BSD-3-Clause
#include "storage/journal.h"

#include <charconv>
#include <string_view>

#include "agrid/storage.h"
#include "storage/checksum.h"
#include "storage/flow_text.h"
#include "storage/tag_reading.h"
#include "storage/tag_text.h"

namespace agrid {
namespace {

constexpr std::size_t kDigits = 16;
constexpr std::string_view kStartWord = "journal ";
constexpr std::string_view kStartOfVersion = "journal 1 ";

std::string withChecksum(const std::string& payload) {
  return hexadecimalOf(checksumOf(payload)) + " " + payload + "\n";
}

/// What a line says, if its checksum is right.
std::optional<std::string_view> payloadOf(std::string_view line) {
  if (line.size() < kDigits + 1 || line[kDigits] != ' ') return std::nullopt;
  const auto checksum = valueOfHexadecimal(line.substr(0, kDigits));
  const std::string_view payload = line.substr(kDigits + 1);
  if (!checksum || *checksum != checksumOf(payload)) return std::nullopt;
  return payload;
}

/// A whole number at the front of a text, which it and the space behind it are taken from.
std::optional<std::uint64_t> takeNumber(std::string_view& text) {
  std::uint64_t number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc()) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(read.ptr - text.data()));
  if (!text.empty()) text.remove_prefix(1);
  return number;
}

std::optional<JournalStart> startOf(std::string_view payload, const std::string& path) {
  if (payload.substr(0, kStartWord.size()) != kStartWord) return std::nullopt;
  if (payload.substr(0, kStartOfVersion.size()) != kStartOfVersion) {
    throw StorageError(StorageErrorCode::kVersion, path + ": a journal of a newer version");
  }
  payload.remove_prefix(kStartOfVersion.size());
  const auto history = valueOfHexadecimal(payload.substr(0, kDigits));
  if (!history || payload.size() < kDigits + 2) return std::nullopt;
  payload.remove_prefix(kDigits + 1);
  const auto sequence = takeNumber(payload);
  if (!sequence) return std::nullopt;
  return JournalStart{*history, *sequence};
}

std::optional<JournalRecord> recordOf(std::string_view payload, StoredText& text, int line) {
  const auto sequence = takeNumber(payload);
  const auto node = parseFlow(payload, line);
  if (!sequence || !node) return std::nullopt;
  try {
    return JournalRecord{*sequence, readEdit(*node, text)};
  } catch (const StorageError&) {
    return std::nullopt;
  }
}

}  // namespace

std::string journalLine(const JournalStart& start) {
  return withChecksum(std::string(kStartOfVersion) + hexadecimalOf(start.history) + " " +
                      std::to_string(start.sequence));
}

std::string journalLine(std::uint64_t sequence, const std::vector<Change>& edit) {
  return withChecksum(std::to_string(sequence) + " " + flowText(edit));
}

ReadJournal readJournal(const std::string& text, const std::string& path) {
  ReadJournal journal;
  StoredText stored{path, {}};
  int number = 0;
  std::string_view rest = text;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    ++number;
    const auto payload = payloadOf(line);
    if (payload && number == 1) journal.start = startOf(*payload, path);
    auto record = payload && number > 1 ? recordOf(*payload, stored, number) : std::nullopt;
    if (record) {
      journal.records.push_back(std::move(*record));
    } else if (number > 1 || !journal.start) {
      // what was being written when the power went ends early or has blocks of zeros in it
      const bool is_torn =
          rest.empty() && (end == std::string_view::npos || line.find('\0') != line.npos);
      if (is_torn) break;
      journal.damage.push_back(path + ":" + std::to_string(number) + ": damaged");
    }
  }
  return journal;
}

}  // namespace agrid
