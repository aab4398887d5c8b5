// SPDX-License-Identifier: BSD-3-Clause
#include <QCoreApplication>
#include <QTest>
#include <atomic>
#include <memory>

#include <gtest/gtest.h>
#include <ros/callback_queue.h>
#include <ros/ros.h>

#include "edit_session.h"

namespace agrid_map_rviz {
namespace {

/// A node whose services answer when they are let, in threads of their own.
class SlowNode : public testing::Test {
 protected:
  SlowNode() : spinner_(2, &queue_) {
    nh_.setCallbackQueue(&queue_);
    graph_service_ = nh_.advertiseService("slow/get_graph", &SlowNode::getGraph, this);
    tag_service_ = nh_.advertiseService("slow/add_tag", &SlowNode::addTag, this);
    remove_service_ = nh_.advertiseService("slow/remove_tag", &SlowNode::removeTag, this);
    spinner_.start();
  }
  ~SlowNode() override { free_ = true; }

  bool getGraph(agrid_map::GetGraph::Request&, agrid_map::GetGraph::Response&) { return true; }
  bool addTag(agrid_map::AddTag::Request&, agrid_map::AddTag::Response& response) {
    ++asked_;
    while (!free_) ros::WallDuration(0.01).sleep();
    response.id = 5;
    return true;
  }
  bool removeTag(agrid_map::RemoveTag::Request& request, agrid_map::RemoveTag::Response&) {
    removed_ = request.id;
    return true;
  }
  static bool comesTrue(const std::function<bool()>& condition) {
    return QTest::qWaitFor(condition, 10000);
  }

  ros::CallbackQueue queue_;
  ros::NodeHandle nh_;
  std::atomic<int> asked_{0};
  std::atomic<std::uint32_t> removed_{0};
  std::atomic<bool> free_{false};
  ros::ServiceServer graph_service_, tag_service_, remove_service_;
  ros::AsyncSpinner spinner_;
};

const std::vector<Change> kChange = {tagAt(agrid_map::Tag::AREA, "map", 1, 1)};

TEST_F(SlowNode, TheWindowGoesOnWhileItWaits) {
  QObject owner;
  EditSession& session = EditSession::of(owner, "slow");
  QStringList answers;
  QObject::connect(&session, &EditSession::answered,
                   [&](bool, const QString& sentence) { answers << sentence; });
  session.apply("named", kChange);
  session.undo();
  // this thread runs the window: it goes on
  ASSERT_TRUE(comesTrue([&] { return asked_ == 1; }));
  EXPECT_TRUE(answers.empty());
  free_ = true;
  ASSERT_TRUE(comesTrue([&] { return answers.size() == 2; }));
  EXPECT_EQ(answers[0], "named");
  EXPECT_EQ(answers[1], "taken back: named");
  EXPECT_EQ(removed_, 5U) << "undo takes back what was still asked for";
}

TEST_F(SlowNode, ClosingTheWindowDoesNotWaitForAnAnswer) {
  auto owner = std::make_unique<QObject>();
  EditSession::of(*owner, "slow").apply("named", kChange);
  EditSession::of(*owner, "slow").apply("named again", kChange);
  ASSERT_TRUE(comesTrue([&] { return asked_ == 1; }));
  owner.reset();
  EXPECT_FALSE(free_) << "the service is still at it";
  EXPECT_EQ(asked_, 1) << "what waited is dropped";
}

TEST_F(SlowNode, ToolAndPanelShareTheSessionWithANode) {
  QObject owner;
  EXPECT_EQ(&EditSession::of(owner, "slow"), &EditSession::of(owner, "slow"));
  EXPECT_NE(&EditSession::of(owner, "slow"), &EditSession::of(owner, "other"));
}

TEST_F(SlowNode, ANodeThatIsNotThereIsASentence) {
  QObject owner;
  EditSession& session = EditSession::of(owner, "nobody");
  QString answer;
  QObject::connect(&session, &EditSession::answered, [&](bool success, const QString& sentence) {
    answer = success ? "" : sentence;
  });
  session.apply("named", kChange);
  EXPECT_TRUE(comesTrue([&] { return answer.contains("nobody offers the service"); }));
}

}  // namespace
}  // namespace agrid_map_rviz
