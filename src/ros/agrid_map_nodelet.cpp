// SPDX-License-Identifier: BSD-3-Clause
#include "ros/agrid_map_nodelet.h"

#include <string>

#include <pluginlib/class_list_macros.hpp>

#include "ros/text.h"

namespace agrid_map_ros {
namespace {

std::string summary(const Snapshot& snapshot) {
  const agrid::SemanticMap& map = *snapshot.map;
  return "Ready: " + std::to_string(map.area_map.areas.size()) + " areas, " +
         std::to_string(map.area_map.doors.size()) + " doors, " +
         std::to_string(map.grid().cellCount()) + " cells in frame '" + snapshot.frame() +
         "', built in " + formatNumber(snapshot.build_seconds) + " s (map_id " +
         map.map().digest() + ")";
}

}  // namespace

AGridNodelet::~AGridNodelet() { cancelled_ = true; }

void AGridNodelet::onInit() {
  ros::NodeHandle& nh = getMTNodeHandle();
  ros::NodeHandle& private_nh = getMTPrivateNodeHandle();
  settings_ = std::make_unique<Settings>(private_nh.getNamespace(), log_);
  const std::string error = settings_->reload();
  listener_ = std::make_unique<tf2_ros::TransformListener>(transforms_, nh);
  outputs_ = std::make_unique<Outputs>(private_nh, log_);
  const auto warn = [this](const std::string& warning) { log_.warn("map", warning); };
  keeper_ = std::make_unique<PlaceKeeper>(PlaceKeeper::Listeners{
      [this](const SnapshotPtr& snapshot) { outputs_->offer(snapshot); },
      [this](const std::string& warning) { log_.warn("tags", warning); },
      [this](const std::string& failure) { log_.error("storage", failure); }});
  const auto read = settings_->parameters();
  const Parameters parameters = read ? *read : Parameters{};
  if (error.empty()) keeper_->open(parameters.storage, private_nh.getNamespace());
  builder_ = std::make_unique<MapBuilder>(
      *keeper_,
      MapBuilder::Listeners{
          [this](const SnapshotPtr& snapshot) { NODELET_INFO_STREAM(summary(*snapshot)); }, warn,
          [this](const std::string& failure) { log_.error("map", failure); }});
  if (error.empty()) builder_->setParameters(read);
  hearing_ = std::make_unique<Hearing>(nh, private_nh,
                                       Hearing::Deps{*keeper_, log_, transforms_, cancelled_},
                                       parameters.hearing.grammar_file);
  services_ = std::make_unique<Services>(
      private_nh,
      Services::Deps{*settings_, *keeper_, *hearing_, *outputs_, log_, transforms_, cancelled_});
  tuning_ = std::make_unique<Tuning>(private_nh, Tuning::Deps{*settings_, *builder_, log_});
  area_watch_ = std::make_unique<AreaWatch>(
      private_nh, AreaWatch::Deps{*keeper_, transforms_, cancelled_, log_},
      parameters.node.area_period);
  diagnostics_ = std::make_unique<Diagnostics>(
      private_nh, Diagnostics::Deps{*settings_, *keeper_, *builder_, log_});
  intake_ = std::make_unique<MapIntake>(nh, MapIntake::Deps{*settings_, *builder_, log_});
}

}  // namespace agrid_map_ros

PLUGINLIB_EXPORT_CLASS(agrid_map_ros::AGridNodelet, nodelet::Nodelet)
