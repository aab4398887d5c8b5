// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "agrid/pipeline/edit.h"
#include "ros/knowledge_file.h"
#include "ros/snapshot.h"

namespace agrid_map_ros {

/// Keeps what is known of the place: in the snapshot in use and on disk, always both or none. The
/// only one who puts snapshots in use. Safe to use from several threads.
class PlaceKeeper {
 public:
  struct Listeners {
    std::function<void(const SnapshotPtr&)> changed;         ///< a new snapshot is in use
    std::function<void(const std::string&)> warned;          ///< for people, one at a time
    std::function<void(const std::string&)> storage_failed;  ///< for people: nothing can be kept
  };

  explicit PlaceKeeper(Listeners listeners);

  /// Opens the file; without that, or if it fails, every edit is refused. To be called before this
  /// is used by several threads.
  void open(const StorageParams& params, const std::string& node_name);
  /// Why nothing can be kept; empty: it can.
  const std::string& storageProblem() const { return problem_; }

  SnapshotPtr snapshot() const;  ///< nullptr before the first map

  /// Lays what is known over a new map and puts it in use.
  /// @param draft  its map annotated with nothing known, its stamp without version
  SnapshotPtr adopt(std::shared_ptr<Snapshot> draft);

  struct EditAnswer {
    std::uint32_t id = 0;
    std::string message;
    SnapshotPtr snapshot;  ///< that shows it
  };
  /// Makes an edit, stores it, then puts it in use. Edits that come meanwhile are stored together.
  /// @param decide  what to do to the newest map
  /// @throws agrid::EditError, agrid::StorageError, RequestError NO_MAP; nothing has changed then
  using Decision = std::function<agrid::Edit(const Snapshot&)>;
  EditAnswer edit(const Decision& decide);

  /// Stores what is known now under another name.
  /// @throws agrid::StorageError, RequestError NO_MAP, STORAGE_FAILED
  void saveAs(const std::string& name);
  /// Writes a file of another kind beside it.
  /// @throws agrid::StorageError, RequestError STORAGE_FAILED
  void saveBeside(const std::string& file, const std::string& bytes);
  /// Puts what was stored under a name in place of all that is known.
  /// @return what became of it on this map, for people
  /// @throws agrid::StorageError, RequestError NO_MAP, STORAGE_FAILED
  std::vector<std::string> load(const std::string& name);

 private:
  struct Waiting {
    const Decision* decide = nullptr;
    EditAnswer answer;
    std::exception_ptr error;
    bool done = false;
  };

  void makeAll(const std::vector<Waiting*>& batch);
  SnapshotPtr withMap(const Snapshot& former, std::shared_ptr<const agrid::SemanticMap> map) const;
  void use(const SnapshotPtr& snapshot);
  SnapshotPtr requireSnapshot() const;
  void requireStorage() const;
  KnowledgeFile& requireFile() const;

  Listeners listeners_;
  mutable std::mutex snapshot_mutex_;  ///< of the pointer alone
  SnapshotPtr snapshot_;
  std::mutex queue_mutex_;
  std::vector<Waiting*> queue_;
  mutable std::mutex commit_mutex_;  ///< who holds it may change what is known
  std::unique_ptr<KnowledgeFile> file_;
  std::string problem_ = "the storage was not opened yet";
  agrid::StoredMap start_;  ///< what was on disk, until the first map is there
  std::uint32_t version_ = 0;
};

}  // namespace agrid_map_ros
