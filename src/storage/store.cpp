// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cerrno>
#include <random>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>

#include "agrid/storage.h"
#include "storage/checksum.h"
#include "storage/directory.h"
#include "storage/journal.h"
#include "storage/recovery.h"
#include "storage/snapshot.h"
#include "storage/tag_text.h"

namespace agrid {
namespace {

constexpr std::uint64_t kLongJournal = 1 << 20;  // [bytes]

std::uint64_t newHistory() {
  std::random_device random;
  return ((std::uint64_t{random()} << 32) | random()) | 1;  // 0 stands for none
}

bool wasRemoved(const FileDescriptor& file) {
  struct stat status {};
  return fstat(file.get(), &status) != 0 || status.st_nlink == 0;
}

}  // namespace

struct Store::State {
  State(const std::string& path, const std::string& name, const StoreOptions& options)
      : name(checkedName(name)),
        read_only(options.read_only),
        files(name),
        directory(path, options.create_directory && !read_only) {
    if (!read_only) {
      lock = directory.lock(files.lock);
      for (const std::string& file : directory.names()) {
        if (isTemporary(file, files.temporary_stem)) directory.remove(file);
      }
    }
    disk = recover(directory, files, !read_only);
    contents = std::move(disk.contents);
    const std::string warning = directory.accessWarning();
    if (!warning.empty()) contents.warnings.push_back(warning);
    if (disk.history == 0) disk.history = newHistory();
    for (const KnownJournal& journal : disk.journals) next_journal = journal.number + 1;
  }

  void checkWritable() const {
    if (!read_only) return;
    throw StorageError(StorageErrorCode::kReadOnly,
                       directory.pathOf(files.snapshot) + ": opened for reading only");
  }

  /// @return the name of the new journal
  std::string startJournal() {
    const std::string file = files.journal(next_journal++);
    journal = directory.create(file);
    disk.journals.push_back({next_journal - 1, 0, false, 0});
    journal_size = 0;
    return file;
  }

  /// Stores text at the end of the journal, or of a new one.
  void write(const std::string& records) {
    if (!directory.isInPlace()) directory.fail("", "is gone", ENOENT);
    if (journal.isOpen() && wasRemoved(journal)) {
      journal.close();
      lost_journal = true;
    }
    const bool is_new = !journal.isOpen();
    const std::string file = is_new ? startJournal() : files.journal(next_journal - 1);
    const std::string text =
        is_new ? journalLine(JournalStart{disk.history, disk.sequence + 1}) + records : records;
    int error = writeAll(journal.get(), text);
    const char* what = error != 0 ? "cannot be written" : "cannot be synced";
    if (error == 0 && fdatasync(journal.get()) != 0) error = errno;
    if (error != 0) {
      abandonJournal(file, is_new);
      directory.fail(file, what, error);
    }
    if (is_new) syncNewJournal(file);
    journal_size += text.size();
    disk.journal_bytes += text.size();
  }

  void syncNewJournal(const std::string& file) {
    try {
      directory.sync();
    } catch (const StorageError&) {
      abandonJournal(file, true);
      throw;
    }
  }

  /// What was not stored must not be found later. Should the file refuse to be cut, the next
  /// journal or snapshot says where it ends.
  void abandonJournal(const std::string& file, bool is_new) {
    if (is_new && directory.remove(file)) {
      disk.journals.pop_back();
    } else {
      const bool is_cut = ftruncate(journal.get(), static_cast<off_t>(journal_size)) == 0;
      if (!is_cut) uncut_sequence = attempted_sequence;
    }
    journal.close();
  }

  void append(const std::vector<std::vector<Change>>& edits) {
    checkWritable();
    if (must_fold) directory.fail(files.snapshot, "not replaced for sure; fold first", EIO);
    std::string records;
    std::uint64_t sequence = disk.sequence;
    for (const std::vector<Change>& edit : edits) {
      for (const Change& change : edit) checkStorable(change);
      if (!edit.empty()) records += journalLine(++sequence, edit);
    }
    if (records.empty()) return;
    attempted_sequence = sequence;
    write(records);
    disk.sequence = sequence;
    disk.journals.back().last_sequence = sequence;
  }

  void checkConflict(const std::string& text) {
    const auto found = directory.identityOf(files.snapshot);
    if (!found || found == disk.snapshot_identity) return;
    const auto file = directory.read(files.snapshot);
    if (!file) return;
    if (disk.snapshot_identity && checksumOf(file->text) == disk.snapshot_checksum) {
      disk.snapshot_identity = file->identity;
      return;
    }
    const std::string kept = directory.writeTemporary(files.temporary_stem, text);
    directory.rename(kept, files.conflict);
    directory.sync();
    throw StorageError(StorageErrorCode::kConflict,
                       directory.pathOf(files.snapshot) +
                           ": changed on disk meanwhile; it stays, and what would have been " +
                           "written is in " + files.conflict);
  }

  void fold(const StoredMap& map) {
    checkWritable();
    checkStorable(map.knowledge);
    const std::uint64_t sequence = std::max(disk.sequence, uncut_sequence);
    const std::string text = snapshotText({map, disk.history, sequence});
    checkConflict(text);
    const std::string temporary = directory.writeTemporary(files.temporary_stem, text);
    try {
      if (directory.identityOf(files.snapshot)) {
        directory.keepAs(files.snapshot, files.backup, files.temporary_stem);
        disk.backup_sequence = disk.snapshot_sequence;
      }
      const auto identity = directory.identityOf(temporary);
      directory.rename(temporary, files.snapshot);
      disk.snapshot_identity = identity;
    } catch (const StorageError&) {
      directory.remove(temporary);
      throw;
    }
    disk.snapshot_sequence = disk.sequence = sequence;
    disk.snapshot_checksum = checksumOf(text);
    disk.snapshot_bytes = text.size();
    journal.close();
    directory.sync();
    must_fold = lost_journal = false;
    disk.journal_bytes = 0;
    retireJournals();
  }

  void replace(const StoredMap& map) {
    const std::uint64_t former_history = std::exchange(disk.history, newHistory());
    const auto former_identity = disk.snapshot_identity;
    const bool had_to_fold = std::exchange(must_fold, true);
    try {
      fold(map);
    } catch (...) {
      if (disk.snapshot_identity == former_identity) {
        disk.history = former_history;
        must_fold = had_to_fold;
      }  // else the new snapshot may be there or not: no edit may follow until one is for sure
      throw;
    }
    try {
      fold(map);  // lest the backup lead back to what was replaced
    } catch (const StorageError&) {
      return;  // it is stored; only its backup is another map's still
    }
  }

  /// Removes the journals that the backup does not need.
  void retireJournals() {
    const auto is_needed = [this](const KnownJournal& known) {
      if (known.last_sequence > disk.backup_sequence) return true;
      const std::string file = files.journal(known.number);
      if (!known.is_damaged) return !directory.remove(file);
      directory.rename(file, directory.freeName(file + ".corrupt"));
      return false;
    };
    std::vector<KnownJournal> needed;
    std::copy_if(disk.journals.begin(), disk.journals.end(), std::back_inserter(needed), is_needed);
    disk.journals = std::move(needed);
  }

  std::string name;
  bool read_only;
  StoreFiles files;
  Directory directory;
  FileDescriptor lock;
  Recovered disk;
  StoreContents contents;
  FileDescriptor journal;
  std::uint64_t next_journal = 1;
  std::uint64_t journal_size = 0;  ///< what of the open one is acknowledged [bytes]
  std::uint64_t attempted_sequence = 0;
  std::uint64_t uncut_sequence = 0;  ///< up to which journals may hold what was refused
  bool must_fold = false;            ///< before anything is appended
  bool lost_journal = false;         ///< somebody removed one: what it held must be folded
};

Store::Store(const std::string& directory, const std::string& name, const StoreOptions& options)
    : state_(std::make_unique<State>(directory, name, options)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

const std::string& Store::name() const { return state_->name; }
const std::string& Store::directory() const { return state_->directory.path(); }
StoreContents Store::takeContents() { return std::exchange(state_->contents, {}); }

void Store::append(const std::vector<Change>& edit) { state_->append({edit}); }
void Store::append(const std::vector<std::vector<Change>>& edits) { state_->append(edits); }

bool Store::journalIsLong() const {
  const Recovered& disk = state_->disk;
  return state_->lost_journal ||
         disk.journal_bytes > std::max(kLongJournal, disk.snapshot_bytes / 2);
}

void Store::fold(const StoredMap& map) { state_->fold(map); }

void Store::replace(const StoredMap& map) { state_->replace(map); }

void Store::saveAs(const std::string& name, const StoredMap& map) const {
  Store(directory(), name).replace(map);
}

void Store::saveBeside(const std::string& file, const std::string& bytes) const {
  state_->checkWritable();
  for (const char* part : {".yaml", ".lock", ".journal-"}) {
    if (checkedName(file).find(part) == std::string::npos) continue;
    throw StorageError(StorageErrorCode::kPath,
                       "'" + file + "': names with '" + part + "' are those of stored maps");
  }
  const Directory& directory = state_->directory;
  const std::string temporary = directory.writeTemporary(state_->files.temporary_stem, bytes);
  try {
    directory.rename(temporary, file);
  } catch (const StorageError&) {
    directory.remove(temporary);
    throw;
  }
  directory.sync();
}

StoreContents Store::loadFrom(const std::string& name) const {
  return readStoredMap(directory() + "/" + checkedName(name) + ".yaml");
}

}  // namespace agrid
