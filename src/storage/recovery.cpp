// SPDX-License-Identifier: BSD-3-Clause
#include "storage/recovery.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <utility>

#include "storage/checksum.h"
#include "storage/journal.h"
#include "storage/snapshot.h"

namespace agrid {
namespace {

struct FoundJournal {
  KnownJournal known;
  std::string name;
  ReadJournal read;
};

class Recovery {
 public:
  Recovery(const Directory& directory, const StoreFiles& files, bool may_rename)
      : directory_(directory), files_(files), may_rename_(may_rename) {}

  Recovered run() {
    const bool has_snapshot = takeSnapshot(files_.snapshot, true);
    const bool has_any = has_snapshot || takeSnapshot(files_.backup, false);
    std::vector<FoundJournal> journals = readJournals();
    result_.contents.is_new = !has_any && journals.empty() && result_.contents.errors.empty();
    if (has_any && !has_snapshot) {
      result_.contents.warnings.push_back(directory_.pathOf(files_.backup) + ": read in place of " +
                                          files_.snapshot);
    }
    chooseHistory(has_any, journals);
    if (!has_any && !result_.contents.errors.empty()) {
      error(directory_.pathOf(files_.snapshot) + ": there is no backup either");
    }
    applyJournals(has_snapshot, journals);
    return std::move(result_);
  }

 private:
  void error(const std::string& what) { result_.contents.errors.push_back(what); }

  bool takeSnapshot(const std::string& name, bool is_current) {
    try {
      const auto file = directory_.read(name);
      if (!file) return false;
      ReadSnapshot read = readSnapshot(file->text, directory_.pathOf(name));
      auto& warnings = result_.contents.warnings;
      warnings.insert(warnings.end(), read.warnings.begin(), read.warnings.end());
      result_.contents.map = std::move(read.snapshot.map);
      result_.history = read.snapshot.history;
      result_.sequence = result_.snapshot_sequence = read.snapshot.sequence;
      result_.snapshot_bytes = file->text.size();
      if (is_current) {
        result_.snapshot_identity = file->identity;
        result_.snapshot_checksum = checksumOf(file->text);
      } else {
        result_.backup_sequence = read.snapshot.sequence;
      }
      return true;
    } catch (const StorageError& failure) {
      if (failure.code() != StorageErrorCode::kCorrupt) throw;
      error(failure.what() + setAside(name, "corrupt"));
      return false;
    }
  }

  /// @return where it is now, for a message
  std::string setAside(const std::string& name, const std::string& why) {
    if (!may_rename_) return "";
    const std::string kept = directory_.freeName(name + "." + why);
    directory_.rename(name, kept);
    directory_.sync();
    return "; kept as " + kept;
  }

  std::vector<FoundJournal> readJournals() const {
    std::vector<FoundJournal> journals;
    for (const std::string& name : directory_.names()) {
      const auto number = files_.journalNumber(name);
      if (!number) continue;
      const auto file = directory_.read(name);
      if (!file) continue;
      FoundJournal journal;
      journal.name = name;
      journal.read = readJournal(file->text, directory_.pathOf(name));
      journal.known.number = *number;
      for (const JournalRecord& record : journal.read.records) {
        journal.known.last_sequence = std::max(journal.known.last_sequence, record.sequence);
      }
      journal.known.is_damaged = !journal.read.damage.empty();
      journal.known.bytes = file->text.size();
      journals.push_back(std::move(journal));
    }
    std::sort(journals.begin(), journals.end(), [](const FoundJournal& a, const FoundJournal& b) {
      return a.known.number < b.known.number;
    });
    return journals;
  }

  void chooseHistory(bool has_snapshot, const std::vector<FoundJournal>& journals) {
    if (has_snapshot) return;
    for (const FoundJournal& journal : journals) {
      if (journal.read.start) result_.history = journal.read.start->history;
    }
  }

  void applyJournals(bool has_snapshot, const std::vector<FoundJournal>& journals) {
    std::map<std::uint64_t, const JournalRecord*> records;
    std::vector<const FoundJournal*> used;
    for (const FoundJournal& journal : journals) {
      const auto& start = journal.read.start;
      if (start && start->history != result_.history) {
        leaveOut(journal, "belongs to another snapshot");
        continue;
      }
      for (const std::string& damage : journal.read.damage) error(damage);
      if (start) records.erase(records.lower_bound(start->sequence), records.end());
      for (const JournalRecord& record : journal.read.records) records[record.sequence] = &record;
      used.push_back(&journal);
    }
    records.erase(records.begin(), records.upper_bound(result_.snapshot_sequence));
    const bool is_older = has_snapshot && !records.empty() &&
                          records.begin()->first != result_.snapshot_sequence + 1 &&
                          std::none_of(used.begin(), used.end(), [](const FoundJournal* journal) {
                            return journal->known.is_damaged;
                          });
    if (is_older) {
      for (const FoundJournal* journal : used) leaveOut(*journal, "continues a newer snapshot");
      return;
    }
    for (const FoundJournal* journal : used) {
      result_.journals.push_back(journal->known);
      const bool is_folded = journal->known.last_sequence <= result_.snapshot_sequence;
      result_.journal_bytes += is_folded ? 0 : journal->known.bytes;
    }
    apply(records);
  }

  void leaveOut(const FoundJournal& journal, const std::string& why) {
    if (journal.read.records.empty()) {
      if (may_rename_) directory_.remove(journal.name);
      return;
    }
    error(directory_.pathOf(journal.name) + ": " + why + ", so its edits are left out" +
          setAside(journal.name, "conflict"));
  }

  void apply(const std::map<std::uint64_t, const JournalRecord*>& records) {
    for (const auto& [sequence, record] : records) {
      if (sequence != result_.sequence + 1) {
        error(directory_.pathOf(files_.snapshot) + ": edits " +
              std::to_string(result_.sequence + 1) + " to " + std::to_string(sequence - 1) +
              " are missing");
      }
      for (const Change& change : record->edit) {
        agrid::apply(change, result_.contents.map.knowledge);
      }
      result_.sequence = sequence;
    }
  }

  const Directory& directory_;
  const StoreFiles& files_;
  bool may_rename_;
  Recovered result_;
};

}  // namespace

StoreFiles::StoreFiles(const std::string& name)
    : snapshot(name + ".yaml"),
      backup(snapshot + ".bak"),
      conflict(snapshot + ".conflict"),
      lock(name + ".lock"),
      temporary_stem("." + name + "."),
      journal_stem(name + ".journal-") {}

std::string StoreFiles::journal(std::uint64_t number) const {
  return journal_stem + std::to_string(number);
}

std::optional<std::uint64_t> StoreFiles::journalNumber(const std::string& file) const {
  if (file.compare(0, journal_stem.size(), journal_stem) != 0) return std::nullopt;
  std::uint64_t number = 0;
  const char* end = file.data() + file.size();
  const auto read = std::from_chars(file.data() + journal_stem.size(), end, number);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return number;
}

Recovered recover(const Directory& directory, const StoreFiles& files, bool may_rename) {
  return Recovery(directory, files, may_rename).run();
}

}  // namespace agrid
