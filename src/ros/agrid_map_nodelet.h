// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <memory>

#include <nodelet/nodelet.h>
#include <tf2_ros/buffer.h>
#include <tf2_ros/transform_listener.h>

#include "ros/area_watch.h"
#include "ros/diagnostics.h"
#include "ros/event_log.h"
#include "ros/hearing.h"
#include "ros/map_builder.h"
#include "ros/map_intake.h"
#include "ros/outputs.h"
#include "ros/place_keeper.h"
#include "ros/services.h"
#include "ros/settings.h"
#include "ros/tuning.h"

namespace agrid_map_ros {

/// Turns the map on the topic `map` into areas, doors and a graph, publishes them and answers
/// questions and requests for plans (doc/interfaces.md, doc/parameters.md). Loading it returns at
/// once; with bad parameters it stays loaded, and its services say what is wrong.
class AGridNodelet : public nodelet::Nodelet {
 public:
  ~AGridNodelet() override;

 private:
  void onInit() override;

  // each uses those above it only, so that they are destroyed in the right order
  std::atomic<bool> cancelled_{false};
  EventLog log_;
  tf2_ros::Buffer transforms_;
  std::unique_ptr<tf2_ros::TransformListener> listener_;
  std::unique_ptr<Settings> settings_;
  std::unique_ptr<Outputs> outputs_;
  std::unique_ptr<PlaceKeeper> keeper_;
  std::unique_ptr<MapBuilder> builder_;
  std::unique_ptr<Hearing> hearing_;
  std::unique_ptr<Services> services_;
  std::unique_ptr<Tuning> tuning_;
  std::unique_ptr<AreaWatch> area_watch_;
  std::unique_ptr<Diagnostics> diagnostics_;
  std::unique_ptr<MapIntake> intake_;
};

}  // namespace agrid_map_ros
