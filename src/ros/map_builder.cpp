// SPDX-License-Identifier: BSD-3-Clause
#include "ros/map_builder.h"

#include <chrono>
#include <utility>

#include <ros/time.h>

#include "agrid/pipeline.h"

namespace agrid_map_ros {

MapBuilder::MapBuilder(PlaceKeeper& keeper, Listeners listeners)
    : keeper_(keeper), listeners_(std::move(listeners)), thread_([this] { run(); }) {}

MapBuilder::~MapBuilder() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    stopping_ = true;
  }
  wake_.notify_all();
  thread_.join();
}

void MapBuilder::setParameters(std::shared_ptr<const Parameters> parameters) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    parameters_ = std::move(parameters);
  }
  wake_.notify_all();
}

void MapBuilder::offer(nav_msgs::OccupancyGridConstPtr map) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = std::move(map);
    pending_ = true;
  }
  wake_.notify_all();
}

bool MapBuilder::rebuild() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!newest_) return false;
    pending_ = true;
    forced_ = true;
  }
  wake_.notify_all();
  return true;
}

MapBuilder::State MapBuilder::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_;
}

void MapBuilder::run() {
  for (;;) {
    nav_msgs::OccupancyGridConstPtr map;
    bool forced = false;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      wake_.wait(lock, [this] { return stopping_ || (pending_ && parameters_); });
      if (stopping_) return;
      map = newest_;
      forced = std::exchange(forced_, false);
      pending_ = false;
      state_ = State::kBuilding;
    }
    try {
      build(map, forced);
    } catch (const std::exception& error) {
      refuse(error.what());
    } catch (...) {
      refuse("unknown exception");
    }
  }
}

void MapBuilder::build(const nav_msgs::OccupancyGridConstPtr& map, bool forced) {
  const auto start = std::chrono::steady_clock::now();
  std::shared_ptr<const Parameters> parameters;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    parameters = parameters_;
  }
  const SnapshotPtr former = keeper_.snapshot();
  ReceivedMap received = fromMsg(*map, parameters->map);
  auto metric = std::make_shared<const agrid::OccupancyMap>(received.grid, parameters->map);
  // a copy of every value that nobody needs any more
  received.grid.values = {};
  if (!forced && former && former->frame() == received.frame_id &&
      former->map->map().digest() == metric->digest()) {
    return accept(map);
  }
  for (const std::string& warning : received.warnings) listeners_.warned(warning);
  for (const std::string& warning : metric->warnings()) listeners_.warned(warning);
  auto snapshot = std::make_shared<Snapshot>();
  snapshot->parameters = std::move(parameters);
  if (!fill(*snapshot, std::move(metric))) return;
  snapshot->stamp.header.frame_id = received.frame_id;
  snapshot->stamp.header.stamp = ros::Time::now();
  snapshot->built = std::chrono::steady_clock::now();
  snapshot->build_seconds = std::chrono::duration<double>(snapshot->built - start).count();
  const SnapshotPtr in_use = keeper_.adopt(std::move(snapshot));
  accept(map);
  listeners_.built(in_use);
}

bool MapBuilder::fill(Snapshot& snapshot, std::shared_ptr<const agrid::OccupancyMap> metric) const {
  const Parameters& parameters = *snapshot.parameters;
  const agrid::Structure structure =
      agrid::extractStructure(std::move(metric), parameters.pipeline);
  if (stopping_) return false;
  snapshot.map = std::make_shared<const agrid::SemanticMap>(
      agrid::annotate(structure, {}, parameters.pipeline));
  if (stopping_) return false;
  for (const std::string& warning : structure.walls.warnings) listeners_.warned(warning);
  for (const std::string& warning : snapshot.map->area_map.warnings) listeners_.warned(warning);
  snapshot.planner = std::make_shared<const agrid::Planner>(snapshot.map, parameters.planner);
  return !stopping_;
}

void MapBuilder::accept(const nav_msgs::OccupancyGridConstPtr& map) {
  const std::lock_guard<std::mutex> lock(mutex_);
  accepted_ = map;
  state_ = State::kReady;
}

void MapBuilder::refuse(const std::string& error) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    // what cannot be built is not worth a rebuild either
    if (!pending_ && accepted_) newest_ = accepted_;
    state_ = State::kFailed;
  }
  listeners_.failed(error);
}

}  // namespace agrid_map_ros
