// SPDX-License-Identifier: BSD-3-Clause
// Many clients at once say, take back and ask what they said, against a model of what must be
// there.
#include <csignal>
#include <cstdio>
#include <random>
#include <set>

#include <agrid_map/AddTag.h>
#include <agrid_map/ListTags.h>
#include <agrid_map/RemoveTag.h>
#include <agrid_map/SaveMap.h>
#include <agrid_map/SetDoor.h>

#include "agrid/storage.h"
#include "node_process.h"
#include "nodelet_client.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using agrid_map::Tag;
using Clock = std::chrono::steady_clock;
using Ids = std::map<std::string, std::uint32_t>;  // of objects, by their names

constexpr int kContested = 4;      // names that every client wants
constexpr std::size_t kMost = 30;  // objects of one client

/// Ids of the objects in an answer; a name that is there twice is a failure.
Ids idsOf(const std::vector<Tag>& tags) {
  Ids ids;
  for (const Tag& tag : tags) {
    EXPECT_TRUE(ids.emplace(tag.name, tag.id).second) << tag.name << " is there twice";
  }
  return ids;
}

Ids idsIn(const std::string& file) {
  const agrid::StoreContents stored = agrid::readStoredMap(file);
  EXPECT_TRUE(stored.errors.empty());
  Ids ids;
  for (const agrid::ObjectTag& tag : stored.map.knowledge.objects) {
    EXPECT_TRUE(ids.emplace(tag.name, static_cast<std::uint32_t>(tag.id)).second) << tag.name;
  }
  return ids;
}

/// One who says at random, and knows what must be true then.
class Client {
 public:
  explicit Client(int number) : number_(number), random_(static_cast<unsigned>(number)) {}

  void actUntil(Clock::time_point end) {
    for (int i = 0; i < kContested; ++i) wish("wanted " + std::to_string(i));
    while (Clock::now() < end && !testing::Test::HasFailure()) act();
  }

  Ids own;
  std::size_t edits = 0;        ///< acknowledged
  std::vector<double> seconds;  ///< that each took
  struct DoorWrite {
    Clock::time_point begin;
    Clock::time_point end;
    std::uint8_t state = 0;
  };
  std::vector<DoorWrite> writes;

 private:
  template <typename Service>
  typename Service::Response ask(ros::ServiceClient& client, typename Service::Request request) {
    typename Service::Response response;
    EXPECT_TRUE(client.call(request, response)) << client.getService();
    return response;
  }
  template <typename Service>
  static ros::ServiceClient clientOf(const std::string& name) {
    return ros::NodeHandle().serviceClient<Service>("agrid/" + name, true);
  }
  std::size_t below(std::size_t bound) {
    return std::uniform_int_distribution<std::size_t>(0, bound - 1)(random_);
  }

  void act() {
    const std::size_t dice = below(100);
    if (dice < 10) return setDoor();
    if (dice < 15) return list();
    if (own.size() < kMost && (own.empty() || dice < 60)) return add();
    removeOne();
  }

  agrid_map::AddTag::Response put(const agrid_map::AddTag::Request& request) {
    const auto begin = Clock::now();
    const auto response = ask<agrid_map::AddTag>(add_, request);
    seconds.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
    return response;
  }
  agrid_map::AddTag::Request object(const std::string& name) {
    agrid_map::AddTag::Request request;
    request.tag.type = Tag::OBJECT;
    request.tag.name = name;
    request.tag.source = Tag::MANUAL;
    request.tag.pose.position.x = 1.2 + 0.07 * number_;
    request.tag.pose.position.y = 1.2 + 0.04 * static_cast<double>(below(100));
    return request;
  }
  /// Everybody may ask for it; one gets it.
  void wish(const std::string& name) {
    const auto response = put(object(name));
    if (response.status.code == Status::NAME_TAKEN) return;
    note(name, response);
  }
  void add() {
    const std::string name = std::to_string(number_) + "." + std::to_string(++count_);
    const auto request = object(name);
    note(name, put(request));
    if (count_ % 8 != 0) return;
    const auto again = put(request);  // as after a lost answer
    EXPECT_EQ(again.status.code, Status::SUCCESS) << again.status.message;
    EXPECT_EQ(again.id, own[name]);
  }
  void note(const std::string& name, const agrid_map::AddTag::Response& response) {
    EXPECT_EQ(response.status.code, Status::SUCCESS) << response.status.message;
    own[name] = response.id;
    ++edits;
  }
  void removeOne() {
    const auto chosen = std::next(own.begin(), static_cast<long>(below(own.size())));
    agrid_map::RemoveTag::Request request;
    request.type = Tag::OBJECT;
    request.id = chosen->second;
    EXPECT_EQ(ask<agrid_map::RemoveTag>(remove_, request).status.code, Status::SUCCESS);
    ++edits;
    own.erase(chosen);
    if (edits % 8 != 0) return;
    EXPECT_EQ(ask<agrid_map::RemoveTag>(remove_, request).status.code, Status::UNKNOWN_NAME);
  }
  void setDoor() {
    agrid_map::SetDoor::Request request;
    request.door = "1";
    request.state = static_cast<std::uint8_t>(1 + below(2));
    DoorWrite write{Clock::now(), {}, request.state};
    const Status status = ask<agrid_map::SetDoor>(door_, request).status;
    EXPECT_EQ(status.code, Status::SUCCESS) << status.message;
    write.end = Clock::now();
    writes.push_back(write);
    ++edits;
  }
  void list() {
    agrid_map::ListTags::Request request;
    request.type = Tag::OBJECT;
    Ids listed = idsOf(ask<agrid_map::ListTags>(list_, request).tags);
    const std::string mine = std::to_string(number_) + ".";
    for (auto entry = listed.begin(); entry != listed.end();) {
      const bool other = own.count(entry->first) == 0 && entry->first.rfind(mine, 0) != 0;
      entry = other ? listed.erase(entry) : std::next(entry);
    }
    EXPECT_EQ(listed, own) << "of client " << number_;
  }

  int number_;
  int count_ = 0;
  std::mt19937 random_;
  ros::ServiceClient add_ = clientOf<agrid_map::AddTag>("add_tag");
  ros::ServiceClient remove_ = clientOf<agrid_map::RemoveTag>("remove_tag");
  ros::ServiceClient list_ = clientOf<agrid_map::ListTags>("list_tags");
  ros::ServiceClient door_ = clientOf<agrid_map::SetDoor>("set_door");
};

class Hammer : public test::NodeletClient {
 protected:
  /// States that a door may have in the end: no later write follows those.
  static std::set<std::uint8_t> lastStates(const std::vector<Client>& clients) {
    Clock::time_point last_begin;
    for (const Client& client : clients) {
      for (const auto& write : client.writes) last_begin = std::max(last_begin, write.begin);
    }
    std::set<std::uint8_t> states;
    for (const Client& client : clients) {
      for (const auto& write : client.writes) {
        if (write.end >= last_begin) states.insert(write.state);
      }
    }
    return states;
  }

  Ids listed() {
    agrid_map::ListTags::Request request;
    request.type = Tag::OBJECT;
    return idsOf(ask<agrid_map::ListTags>("agrid/list_tags", request).tags);
  }

  static void report(const std::vector<Client>& clients, double seconds) {
    std::size_t edits = 0;
    std::vector<double> each;
    for (const Client& client : clients) {
      edits += client.edits;
      each.insert(each.end(), client.seconds.begin(), client.seconds.end());
    }
    std::sort(each.begin(), each.end());
    std::printf(
        "%zu clients, %.1f s: %zu edits acknowledged, %.0f a second; an object is added in "
        "%.1f ms (median), %.1f ms (99 %%), %.1f ms (most)\n",
        clients.size(), seconds, edits, static_cast<double>(edits) / seconds,
        1e3 * each.at(each.size() / 2), 1e3 * each.at(each.size() * 99 / 100), 1e3 * each.back());
    std::fflush(stdout);
  }
};

TEST_F(Hammer, T17_WhatManyClientsSayIsThereExactlyOnce) {
  std::string folder;
  ASSERT_TRUE(ros::param::get("~folder", folder));
  const double seconds = ros::param::param("~seconds", 4.0);
  useTwoRooms();
  ASSERT_EQ(graph().doors.size(), 1U);
  std::vector<Client> clients;
  for (int i = 0; i < ros::param::param("~clients", 64); ++i) clients.emplace_back(i);
  const auto begin = Clock::now();
  std::vector<std::thread> threads;
  for (Client& client : clients) {
    threads.emplace_back([&client, end = begin + std::chrono::duration_cast<Clock::duration>(
                                                     std::chrono::duration<double>(seconds))] {
      client.actUntil(end);
    });
  }
  for (std::thread& thread : threads) thread.join();
  report(clients, std::chrono::duration<double>(Clock::now() - begin).count());

  Ids model;
  for (const Client& client : clients) {
    for (const auto& [name, id] : client.own) {
      EXPECT_TRUE(model.emplace(name, id).second) << name << " was given to two clients";
    }
  }
  EXPECT_EQ(listed(), model);
  const auto states = lastStates(clients);
  EXPECT_TRUE(states.empty() || states.count(graph().doors.at(0).state) == 1);
  EXPECT_EQ(idsIn(folder + "/hammered.yaml"), model) << "with its journal";
  agrid_map::SaveMap::Request save;
  save.name = "copy.yaml";
  EXPECT_EQ(ask<agrid_map::SaveMap>("agrid/save_map", save).status.code, Status::SUCCESS);
  EXPECT_EQ(idsIn(folder + "/copy.yaml"), model);
  const std::uint8_t state = graph().doors.at(0).state;
  ASSERT_EQ(kill(test::processOf("/agrid"), SIGKILL), 0);
  ASSERT_TRUE(test::eventually([&] {
    agrid_map::GetGraph service;
    return ros::service::call("agrid/get_graph", service) &&
           service.response.status.code == Status::SUCCESS;
  }));
  EXPECT_EQ(listed(), model) << "after it was killed";
  EXPECT_EQ(graph().doors.at(0).state, state);
}

}  // namespace
}  // namespace agrid_map_ros

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  ros::init(argc, argv, "agrid_tag_hammer_nodelet_test");
  ros::start();
  return RUN_ALL_TESTS();
}
