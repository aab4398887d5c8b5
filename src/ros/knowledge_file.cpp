// SPDX-License-Identifier: BSD-3-Clause
#include "ros/knowledge_file.h"

#include <cstdlib>
#include <utility>

namespace agrid_map_ros {
namespace {

constexpr auto kBetweenFolds = std::chrono::seconds(10);
constexpr std::uint32_t kIdsAhead = 1000;

std::string directoryOf(const StorageParams& params) {
  if (!params.directory.empty()) return params.directory;
  if (const char* ros_home = std::getenv("ROS_HOME")) return std::string(ros_home) + "/agrid_map";
  const char* home = std::getenv("HOME");
  return std::string(home ? home : ".") + "/.ros/agrid_map";
}

std::string fileName(const StorageParams& params, const std::string& node_name) {
  if (!params.name.empty()) return params.name;
  std::string name;
  for (const char c : node_name) {
    if (c == '/' && name.empty()) continue;
    name += c == '/' ? '.' : c;
  }
  return name;
}

bool exceeds(const agrid::NextIds& used, const agrid::NextIds& reserved) {
  return used.area > reserved.area || used.door > reserved.door || used.object > reserved.object;
}

}  // namespace

KnowledgeFile::KnowledgeFile(const StorageParams& params, const std::string& node_name)
    : store_(directoryOf(params), agrid::checkedName(fileName(params, node_name)),
             {params.read_only, true}) {
  agrid::StoreContents contents = store_.takeContents();
  errors_ = std::move(contents.errors);
  warnings_ = std::move(contents.warnings);
  reserved_ = contents.map.knowledge.next_ids;
  on_disk_ = std::make_shared<const agrid::StoredMap>(std::move(contents.map));
  latest_ = on_disk_;
}

KnowledgeFile::~KnowledgeFile() {
  try {
    fold(latest_);
  } catch (const std::exception&) {
    // all that was acknowledged is in the journal; the next start folds it
  }
}

void KnowledgeFile::store(const std::vector<std::shared_ptr<const agrid::StoredMap>>& steps) {
  const agrid::StoredMap& now = *steps.back();
  // a journal does not tell on which map its edits were made
  if (now.map_id != on_disk_->map_id || now.frame_id != on_disk_->frame_id) {
    return fold(steps.back());
  }
  std::vector<std::vector<agrid::Change>> edits;
  const agrid::Knowledge* before = &on_disk_->knowledge;
  for (const auto& step : steps) {
    edits.push_back(agrid::difference(*before, step->knowledge));
    before = &step->knowledge;
  }
  store_.append(edits);
  on_disk_ = steps.back();
  latest_ = steps.back();
  if (exceeds(latest_->knowledge.next_ids, reserved_)) reserved_ = latest_->knowledge.next_ids;
  if (!store_.journalIsLong()) return;
  try {
    fold(latest_);
  } catch (const agrid::StorageError&) {
    // the edits are stored; the journal goes on growing until there is room for another snapshot
  }
}

void KnowledgeFile::follow(std::shared_ptr<const agrid::StoredMap> now) {
  latest_ = std::move(now);
  if (!folded_ || Clock::now() - *folded_ >= kBetweenFolds) {
    fold(latest_);
  } else if (exceeds(latest_->knowledge.next_ids, reserved_)) {
    reserveIds(latest_->knowledge.next_ids);
  }
}

void KnowledgeFile::saveAs(const std::string& name, const agrid::StoredMap& map) {
  store_.saveAs(name, map);
}

void KnowledgeFile::saveBeside(const std::string& file, const std::string& bytes) {
  store_.saveBeside(file, bytes);
}

agrid::StoreContents KnowledgeFile::loadFrom(const std::string& name) const {
  return store_.loadFrom(name);
}

void KnowledgeFile::fold(std::shared_ptr<const agrid::StoredMap> now) {
  store_.fold(*now);
  on_disk_ = now;
  latest_ = std::move(now);
  reserved_ = on_disk_->knowledge.next_ids;
  folded_ = Clock::now();
}

void KnowledgeFile::reserveIds(const agrid::NextIds& used) {
  const agrid::NextIds ahead{used.area + kIdsAhead, used.door + kIdsAhead, used.object + kIdsAhead};
  store_.append(std::vector<agrid::Change>{agrid::ReserveIds{ahead}});
  reserved_ = ahead;
}

}  // namespace agrid_map_ros
