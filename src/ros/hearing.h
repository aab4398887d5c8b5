// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <optional>
#include <string>

#include <geometry_msgs/PointStamped.h>
#include <ros/node_handle.h>
#include <ros/publisher.h>
#include <ros/subscriber.h>
#include <std_msgs/String.h>
#include <tf2/buffer_core.h>

#include <agrid_map/Query.h>
#include <agrid_map/Tag.h>

#include "agrid/dialogue/grammar.h"
#include "ros/event_log.h"
#include "ros/place_keeper.h"
#include "ros/plan_answers.h"

namespace agrid_map_ros {

/// What a clicked point is to become: the parameter `click_tag`, a kind and perhaps a name, such as
/// "door" or "area kitchen".
/// @throws std::invalid_argument if it begins with no kind
agrid_map::Tag clickedTag(const std::string& click_tag, const geometry_msgs::PointStamped& point);

/// Hears tags on ~tag, points on clicked_point and sentences on ~say, and answers these on ~said.
/// What comes over a topic has no response: what is wrong with it goes to the log.
class Hearing {
 public:
  /// All must outlive this.
  struct Deps {
    PlaceKeeper& keeper;
    EventLog& log;
    const tf2::BufferCore& transforms;
    const std::atomic<bool>& cancelled;
  };
  /// @param grammar_file  empty: English; one that cannot be used is an error in the log
  Hearing(ros::NodeHandle& nh, ros::NodeHandle& private_nh, const Deps& deps,
          const std::string& grammar_file);

  /// The answer to a question about how things lie to each other.
  /// @throws RequestError, LookupError
  agrid_map::Query::Response answerQuery(const Ground& ground,
                                         const agrid_map::Query::Request& request) const;

 private:
  void onTag(const agrid_map::Tag& tag);
  void onClick(const geometry_msgs::PointStamped& point);
  void onSentence(const std_msgs::String& sentence);
  std::string answerTo(const std::string& sentence);
  void add(const agrid_map::Tag& tag);
  Frames framesOf(const Snapshot& snapshot) const;
  std::optional<agrid::Pose2> robotPose(const Snapshot& snapshot) const;

  Deps deps_;
  agrid::dialogue::Grammar grammar_;
  ros::Publisher said_;
  ros::Subscriber tag_;
  ros::Subscriber click_;
  ros::Subscriber say_;
};

}  // namespace agrid_map_ros
