// SPDX-License-Identifier: BSD-3-Clause
#include "ros/hearing.h"

#include <array>
#include <stdexcept>
#include <utility>
#include <variant>

#include "agrid/dialogue/replies.h"
#include "agrid_map_ros/conversions.h"
#include "ros/boundary.h"
#include "ros/edit_answers.h"
#include "ros/request_error.h"
#include "ros/text.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

constexpr std::array<const char*, 3> kKinds{"area", "door", "object"};
constexpr std::size_t kLongestSentence = 4096;  // bytes

agrid::dialogue::Grammar grammarFrom(const std::string& file, EventLog& log) {
  if (file.empty()) return agrid::dialogue::englishGrammar();
  try {
    return agrid::dialogue::loadGrammar(file);
  } catch (const std::exception& error) {
    log.error("grammar", std::string(error.what()) + "; English is spoken instead");
    return agrid::dialogue::englishGrammar();
  }
}

struct AsRequest {
  agrid::EditRequest operator()(const agrid::dialogue::TagToPut& put) const {
    agrid::AddTag add;
    add.tag = put.tag;
    if (put.stays) add.placement = agrid::Placement::kUnchanged;
    return add;
  }
  agrid::EditRequest operator()(const agrid::dialogue::TagToDrop& drop) const {
    return agrid::RemoveTag{drop.kind, drop.id};
  }
  agrid::EditRequest operator()(const agrid::dialogue::StateToSet& set) const {
    return agrid::SetDoor{set.door, set.state, agrid::TagSource::kInteraction};
  }
};

}  // namespace

agrid_map::Tag clickedTag(const std::string& click_tag, const geometry_msgs::PointStamped& point) {
  agrid_map::Tag tag;
  tag.header = point.header;
  tag.pose.position = point.point;
  tag.source = agrid_map::Tag::MANUAL;
  for (std::size_t i = 0; i < kKinds.size(); ++i) {
    const std::string kind = kKinds[i];
    if (click_tag != kind && click_tag.compare(0, kind.size() + 1, kind + " ") != 0) continue;
    tag.type = static_cast<std::uint8_t>(i + 1);
    if (click_tag.size() > kind.size()) tag.name = click_tag.substr(kind.size() + 1);
    return tag;
  }
  throw std::invalid_argument("click_tag is '" + printable(click_tag) +
                              "', must begin with area, door or object");
}

Hearing::Hearing(ros::NodeHandle& nh, ros::NodeHandle& private_nh, const Deps& deps,
                 const std::string& grammar_file)
    : deps_(deps),
      grammar_(grammarFrom(grammar_file, deps.log)),
      said_(private_nh.advertise<std_msgs::String>("said", 10)),
      tag_(private_nh.subscribe("tag", 100, &Hearing::onTag, this)),
      click_(nh.subscribe("clicked_point", 10, &Hearing::onClick, this)),
      say_(private_nh.subscribe("say", 10, &Hearing::onSentence, this)) {}

void Hearing::onTag(const agrid_map::Tag& tag) {
  const auto failure = attempt(deps_.log, "tag", [&] { add(tag); });
  if (!failure) return;
  deps_.log.warn("tag", "the tag '" + printable(tag.name.substr(0, 256)) +
                            "' is refused: " + failure->message);
}

void Hearing::onClick(const geometry_msgs::PointStamped& point) {
  const auto failure = attempt(deps_.log, "tag", [&] {
    const SnapshotPtr snapshot = deps_.keeper.snapshot();
    if (!snapshot || snapshot->parameters->hearing.click_tag.empty()) return;
    add(clickedTag(snapshot->parameters->hearing.click_tag, point));
  });
  if (failure) deps_.log.warn("tag", "the clicked point is refused: " + failure->message);
}

void Hearing::onSentence(const std_msgs::String& sentence) {
  attempt(deps_.log, "say", [&] {
    std_msgs::String answer;
    const auto failure = attempt(deps_.log, "say", [&] {
      answer.data = answerTo(sentence.data.substr(0, kLongestSentence));
    });
    if (failure) {
      answer.data = agrid::dialogue::refusal(grammar_, failure->message);
      deps_.log.warn("say", answer.data);
    }
    said_.publish(answer);
  });
}

std::string Hearing::answerTo(const std::string& sentence) {
  const SnapshotPtr snapshot = deps_.keeper.snapshot();
  if (!snapshot) return agrid::dialogue::noMapYet(grammar_);
  const auto reply = agrid::dialogue::respond(grammar_, *snapshot->map, sentence,
                                              robotPose(*snapshot), snapshot->parameters->dialogue);
  if (!reply.edit) return reply.sentence;
  const agrid::EditRequest request = std::visit(AsRequest{}, *reply.edit);
  deps_.keeper.edit([&request](const Snapshot& newest) {
    return agrid::decide(request, *newest.map, editParams(*newest.parameters));
  });
  return reply.sentence;
}

void Hearing::add(const agrid_map::Tag& tag) {
  const SnapshotPtr snapshot = deps_.keeper.snapshot();
  if (!snapshot) throw RequestError(Status::NO_MAP, "no map has been built yet");
  const agrid::AddTag add = tagFromMsg(framesOf(*snapshot), tag);
  deps_.keeper.edit([&add](const Snapshot& newest) {
    return agrid::decide(add, *newest.map, editParams(*newest.parameters));
  });
}

Frames Hearing::framesOf(const Snapshot& snapshot) const {
  return Frames(deps_.transforms, deps_.cancelled, snapshot.frame(),
                snapshot.parameters->node.tf_timeout);
}

std::optional<agrid::Pose2> Hearing::robotPose(const Snapshot& snapshot) const {
  try {
    return framesOf(snapshot).robotPose(snapshot.parameters->node.base_frame);
  } catch (const RequestError&) {
    return std::nullopt;  // the answer says so if it is needed
  }
}

agrid_map::Query::Response Hearing::answerQuery(const Ground& ground,
                                                const agrid_map::Query::Request& request) const {
  using agrid::dialogue::QueryStatus;
  const Snapshot& snapshot = ground.snapshot;
  const std::string question = request.question.substr(0, kLongestSentence);
  std::optional<agrid::Pose2> robot;
  auto answer = agrid::dialogue::answerQuery(grammar_, *snapshot.map, question, robot,
                                             snapshot.parameters->dialogue);
  if (answer.status == QueryStatus::kNoPose) {
    robot = ground.frames.robotPose(snapshot.parameters->node.base_frame);
    answer = agrid::dialogue::answerQuery(grammar_, *snapshot.map, question, robot,
                                          snapshot.parameters->dialogue);
  }
  agrid_map::Query::Response response;
  if (answer.status != QueryStatus::kAnswered) {
    throw RequestError(Status::INVALID_REQUEST, printable(answer.sentence));
  }
  response.answer = answer.sentence;
  for (const agrid::Thing& thing : answer.things) {
    response.things.push_back(tagOf(thing, snapshot.stamp.header));
  }
  return response;
}

}  // namespace agrid_map_ros
