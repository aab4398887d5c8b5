// SPDX-License-Identifier: BSD-3-Clause
#include "ros/place_keeper.h"

#include <csignal>
#include <utility>

#include <ros/time.h>

#include "agrid/identity/recognition.h"
#include "agrid/pipeline.h"
#include "ros/request_error.h"

namespace agrid_map_ros {
namespace {

bool isEmpty(const agrid::Knowledge& known) {
  return known.areas.empty() && known.doors.empty() && known.objects.empty() &&
         known.pending.empty() && known.next_ids.area == 1 && known.next_ids.door == 1 &&
         known.next_ids.object == 1;
}

std::shared_ptr<const agrid::StoredMap> storedOf(const Snapshot& snapshot) {
  return std::make_shared<const agrid::StoredMap>(
      agrid::StoredMap{snapshot.map->map().digest(), snapshot.frame(), snapshot.map->knowledge});
}

/// What is known, laid over a map, and what people should know about it.
struct Laid {
  std::shared_ptr<const agrid::SemanticMap> map;
  std::vector<std::string> report;
};

/// @param fresh  annotated with whatever
Laid layOver(const agrid::SemanticMap& fresh, const std::string& frame,
             const agrid::StoredMap& known) {
  Laid laid;
  if (known.map_id == fresh.map().digest() && known.frame_id == frame) {
    laid.map = std::make_shared<const agrid::SemanticMap>(agrid::retag(fresh, known.knowledge));
    return laid;
  }
  const agrid::SemanticMap with_doors =
      agrid::retag(fresh, agrid::doorsFor(frame, known.knowledge, known.frame_id));
  agrid::Recognition found = agrid::recognise(known.knowledge, known.frame_id, with_doors, frame);
  laid.map = std::make_shared<const agrid::SemanticMap>(agrid::retag(with_doors, found.knowledge));
  laid.report = std::move(found.report);
  return laid;
}

}  // namespace

PlaceKeeper::PlaceKeeper(Listeners listeners) : listeners_(std::move(listeners)) {}

void PlaceKeeper::open(const StorageParams& params, const std::string& node_name) {
  problem_ = params.read_only ? "the node was started with read_only" : "";
  if (!params.persistent) {
    listeners_.warned("persistent is false: what people say is forgotten when the node ends");
    return;
  }
  // a file beyond its limit is an error of the write, not the end of the process
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    file_ = std::make_unique<KnowledgeFile>(params, node_name);
    start_ = file_->atStart();
    for (const std::string& error : file_->errors()) listeners_.storage_failed(error);
    for (const std::string& warning : file_->warnings()) listeners_.warned(warning);
  } catch (const std::exception& error) {
    problem_ = error.what();
    listeners_.storage_failed(std::string("nothing that people say can be kept: ") + error.what());
  }
}

SnapshotPtr PlaceKeeper::snapshot() const {
  const std::lock_guard<std::mutex> lock(snapshot_mutex_);
  return snapshot_;
}

SnapshotPtr PlaceKeeper::adopt(std::shared_ptr<Snapshot> draft) {
  const std::lock_guard<std::mutex> lock(commit_mutex_);
  const SnapshotPtr former = snapshot();
  auto known = former ? *storedOf(*former) : start_;
  // other parameters make other areas of the same map
  if (former && former->parameters != draft->parameters) known.map_id.clear();
  if (!isEmpty(known.knowledge)) {
    Laid laid = layOver(*draft->map, draft->frame(), known);
    for (const std::string& sentence : laid.report) listeners_.warned(sentence);
    draft->planner = std::make_shared<const agrid::Planner>(laid.map, *draft->planner);
    draft->map = std::move(laid.map);
  }
  draft->stamp.version = ++version_;
  if (file_) {
    try {
      file_->follow(storedOf(*draft));
    } catch (const std::exception& error) {
      listeners_.storage_failed(std::string("what became of the tags on the new map could not be "
                                            "stored yet: ") +
                                error.what());
    }
  }
  use(draft);
  return draft;
}

PlaceKeeper::EditAnswer PlaceKeeper::edit(const Decision& decide) {
  Waiting own;
  own.decide = &decide;
  {
    const std::lock_guard<std::mutex> lock(queue_mutex_);
    queue_.push_back(&own);
  }
  {
    // whoever comes first makes and stores the edits of all who wait
    const std::lock_guard<std::mutex> lock(commit_mutex_);
    if (!own.done) {
      std::vector<Waiting*> batch;
      {
        const std::lock_guard<std::mutex> queue_lock(queue_mutex_);
        batch.swap(queue_);
      }
      makeAll(batch);
    }
  }
  if (own.error) std::rethrow_exception(own.error);
  return own.answer;
}

void PlaceKeeper::makeAll(const std::vector<Waiting*>& batch) {
  SnapshotPtr now = snapshot();
  std::vector<std::shared_ptr<const agrid::StoredMap>> steps;
  for (Waiting* waiting : batch) {
    waiting->done = true;
    try {
      if (!now) now = requireSnapshot();
      requireStorage();
      const agrid::Edit edit = (*waiting->decide)(*now);
      waiting->answer.id = edit.id;
      waiting->answer.message = edit.message;
      if (edit.changed()) {
        agrid::Knowledge known = now->map->knowledge;
        for (const agrid::Change& change : edit.changes) agrid::apply(change, known);
        now = withMap(*now,
                      std::make_shared<const agrid::SemanticMap>(agrid::retag(*now->map, known)));
        steps.push_back(storedOf(*now));
      }
      waiting->answer.snapshot = now;
    } catch (...) {
      waiting->error = std::current_exception();
    }
  }
  if (steps.empty()) return;
  try {
    if (file_) file_->store(steps);
    use(now);
  } catch (...) {
    // also those that had nothing to change, for what they saw there is not
    for (Waiting* waiting : batch) {
      if (!waiting->error) waiting->error = std::current_exception();
    }
  }
}

void PlaceKeeper::saveAs(const std::string& name) {
  const std::lock_guard<std::mutex> lock(commit_mutex_);
  const SnapshotPtr now = requireSnapshot();
  requireFile();
  file_->saveAs(name, *storedOf(*now));
}

void PlaceKeeper::saveBeside(const std::string& file, const std::string& bytes) {
  const std::lock_guard<std::mutex> lock(commit_mutex_);
  requireFile().saveBeside(file, bytes);
}

std::vector<std::string> PlaceKeeper::load(const std::string& name) {
  const std::lock_guard<std::mutex> lock(commit_mutex_);
  const SnapshotPtr now = requireSnapshot();
  requireFile();
  agrid::StoreContents contents = file_->loadFrom(name);
  if (!contents.errors.empty()) {
    throw RequestError(agrid_map::Status::STORAGE_FAILED, contents.errors.front());
  }
  agrid::apply(agrid::ReserveIds{now->map->knowledge.next_ids}, contents.map.knowledge);
  Laid laid = layOver(*now->map, now->frame(), contents.map);
  const SnapshotPtr loaded = withMap(*now, std::move(laid.map));
  file_->store({storedOf(*loaded)});
  use(loaded);
  laid.report.insert(laid.report.end(), contents.warnings.begin(), contents.warnings.end());
  return laid.report;
}

SnapshotPtr PlaceKeeper::requireSnapshot() const {
  if (SnapshotPtr now = snapshot()) return now;
  throw RequestError(agrid_map::Status::NO_MAP, "no map has been built yet");
}

SnapshotPtr PlaceKeeper::withMap(const Snapshot& former,
                                 std::shared_ptr<const agrid::SemanticMap> map) const {
  auto snapshot = std::make_shared<Snapshot>(former);
  snapshot->planner = std::make_shared<const agrid::Planner>(map, *former.planner);
  snapshot->map = std::move(map);
  snapshot->stamp.header.stamp = ros::Time::now();
  snapshot->stamp.version = former.stamp.version + 1;
  return snapshot;
}

void PlaceKeeper::use(const SnapshotPtr& snapshot) {
  version_ = snapshot->stamp.version;
  {
    const std::lock_guard<std::mutex> lock(snapshot_mutex_);
    snapshot_ = snapshot;
  }
  listeners_.changed(snapshot);
}

void PlaceKeeper::requireStorage() const {
  if (!problem_.empty()) throw RequestError(agrid_map::Status::STORAGE_FAILED, problem_);
}

/// @throws RequestError if there is none
KnowledgeFile& PlaceKeeper::requireFile() const {
  requireStorage();
  if (file_) return *file_;
  throw RequestError(agrid_map::Status::STORAGE_FAILED,
                     "the node was started with persistent false");
}

}  // namespace agrid_map_ros
