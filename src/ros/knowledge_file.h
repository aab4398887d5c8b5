// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agrid/storage.h"
#include "agrid_map_ros/parameters.h"

namespace agrid_map_ros {

/// What is known of the place, as it is on disk. Not safe for use by two threads at once.
class KnowledgeFile {
 public:
  /// @param node_name  with its namespace
  /// @throws agrid::StorageError if the file cannot be used
  KnowledgeFile(const StorageParams& params, const std::string& node_name);
  /// Folds the journal into the file.
  ~KnowledgeFile();
  KnowledgeFile(const KnowledgeFile&) = delete;
  KnowledgeFile& operator=(const KnowledgeFile&) = delete;

  /// What was on disk at the start.
  const agrid::StoredMap& atStart() const { return *on_disk_; }
  const std::vector<std::string>& errors() const { return errors_; }  ///< at the start, for people
  const std::vector<std::string>& warnings() const { return warnings_; }

  /// Stores what edits lead to; when it returns, no crash takes it away.
  /// @param steps  what is known after each edit, the last one being what is known now; each of
  ///               them whole or not at all
  /// @throws agrid::StorageError; nothing is stored then
  void store(const std::vector<std::shared_ptr<const agrid::StoredMap>>& steps);

  /// Notes what became of the knowledge on a new map: nobody said anything new, so it is written
  /// when edits come or at the end, at most every ten seconds. New ids are never used again,
  /// whatever happens.
  /// @throws agrid::StorageError
  void follow(std::shared_ptr<const agrid::StoredMap> now);

  /// @param name  see agrid::checkedName
  /// @throws agrid::StorageError
  void saveAs(const std::string& name, const agrid::StoredMap& map);
  /// @param file  see agrid::Store::saveBeside
  /// @throws agrid::StorageError
  void saveBeside(const std::string& file, const std::string& bytes);
  agrid::StoreContents loadFrom(const std::string& name) const;

 private:
  using Clock = std::chrono::steady_clock;

  void fold(std::shared_ptr<const agrid::StoredMap> now);
  void reserveIds(const agrid::NextIds& used);

  agrid::Store store_;
  std::shared_ptr<const agrid::StoredMap> on_disk_;
  std::shared_ptr<const agrid::StoredMap> latest_;  ///< what is to be written at the end
  agrid::NextIds reserved_;
  std::optional<Clock::time_point> folded_;
  std::vector<std::string> errors_;
  std::vector<std::string> warnings_;
};

}  // namespace agrid_map_ros
