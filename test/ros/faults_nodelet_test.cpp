// SPDX-License-Identifier: BSD-3-Clause
// Clients that vanish or ask too much, and a node that is told to end while it stores.
#include <atomic>
#include <csignal>
#include <cstdio>
#include <set>

#include <arpa/inet.h>
#include <netdb.h>
#include <ros/header.h>
#include <ros/network.h>
#include <ros/service_manager.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <agrid_map/AddTag.h>
#include <agrid_map/ListTags.h>

#include "agrid/storage.h"
#include "node_process.h"
#include "nodelet_client.h"
#include "support/temporary_folder.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;
using agrid_map::Tag;
using Clock = std::chrono::steady_clock;

agrid_map::AddTag::Request objectCalled(const std::string& name) {
  agrid_map::AddTag::Request request;
  request.tag.type = Tag::OBJECT;
  request.tag.name = name;
  request.tag.source = Tag::MANUAL;
  request.tag.pose.position.x = 3;
  request.tag.pose.position.y = 3;
  return request;
}

/// A client that speaks TCPROS by itself, so that it can hang up when it likes.
class RawClient {
 public:
  RawClient(const std::string& service, const std::string& md5sum) {
    std::string host;
    std::uint32_t port = 0;
    EXPECT_TRUE(ros::ServiceManager::instance()->lookupService(service, host, port));
    addrinfo hints{};
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    EXPECT_EQ(getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found), 0);
    socket_ = socket(AF_INET, SOCK_STREAM, 0);
    EXPECT_EQ(connect(socket_, found->ai_addr, found->ai_addrlen), 0);
    freeaddrinfo(found);
    const ros::M_string fields{
        {"callerid", "/raw"}, {"service", service}, {"md5sum", md5sum}, {"persistent", "1"}};
    boost::shared_array<std::uint8_t> bytes;
    std::uint32_t size = 0;
    ros::Header::write(fields, bytes, size);
    write(&size, sizeof size);
    write(bytes.get(), size);
    std::uint32_t answer = 0;  // the length of the other's header; what it holds does not matter
    EXPECT_EQ(recv(socket_, &answer, sizeof answer, MSG_WAITALL), ssize_t{sizeof answer});
  }
  RawClient(const RawClient&) = delete;
  RawClient& operator=(const RawClient&) = delete;
  ~RawClient() { close(socket_); }

  /// Sends this share of a request.
  void send(const agrid_map::AddTag::Request& request, double share) {
    const ros::SerializedMessage message = ros::serialization::serializeMessage(request);
    write(message.buf.get(),
          static_cast<std::size_t>(share * static_cast<double>(message.num_bytes)));
  }

 private:
  void write(const void* data, std::size_t size) {
    EXPECT_EQ(::send(socket_, data, size, MSG_NOSIGNAL), static_cast<ssize_t>(size));
  }
  int socket_ = -1;
};

class Faults : public test::NodeletClient {
 protected:
  std::multiset<std::string> objects(const std::string& node = "agrid") {
    agrid_map::ListTags::Request request;
    request.type = Tag::OBJECT;
    std::multiset<std::string> names;
    for (const Tag& tag : ask<agrid_map::ListTags>(node + "/list_tags", request).tags) {
      names.insert(tag.name);
    }
    return names;
  }
};

TEST_F(Faults, T18_WhoHangsUpMayAskAgain) {
  useTwoRooms();
  const std::string md5sum = ros::service_traits::md5sum<agrid_map::AddTag>();
  for (const double share : {0.0, 0.1, 0.9, 1.0}) {
    for (int i = 0; i < 8; ++i) {
      const std::string name = "hung up " + std::to_string(share) + " " + std::to_string(i);
      RawClient(ros::names::resolve("agrid/add_tag"), md5sum).send(objectCalled(name), share);
      if (share < 1) {
        EXPECT_EQ(objects().count(name), 0U) << name;
        continue;
      }
      EXPECT_LE(objects().count(name), 1U) << name;  // a list tells what became of it
      const auto first = ask<agrid_map::AddTag>("agrid/add_tag", objectCalled(name));
      EXPECT_EQ(first.status.code, Status::SUCCESS) << first.status.message;
      EXPECT_EQ(ask<agrid_map::AddTag>("agrid/add_tag", objectCalled(name)).id, first.id);
      EXPECT_EQ(objects().count(name), 1U) << name;
    }
  }
}

TEST_F(Faults, T19_AHugeNameIsRefusedAndTheNodeLives) {
  useTwoRooms();
  const auto bytes = static_cast<std::size_t>(ros::param::param("~megabytes", 50)) << 20U;
  const pid_t process = test::processOf("/agrid");
  const auto before = objects();
  const auto begin = Clock::now();
  const auto response =
      ask<agrid_map::AddTag>("agrid/add_tag", objectCalled(std::string(bytes, 'x')));
  std::printf("%zu bytes: answered after %.2f s, at most %ld kB and then %ld kB in memory\n", bytes,
              std::chrono::duration<double>(Clock::now() - begin).count(),
              test::kilobytesOf(process, "VmHWM:"), test::kilobytesOf(process));
  EXPECT_EQ(response.status.code, Status::INVALID_REQUEST);
  EXPECT_LT(response.status.message.size(), 1000U);
  EXPECT_EQ(test::processOf("/agrid"), process);
  EXPECT_EQ(objects(), before);
}

/// A node of its own that the test may end.
class Ending : public Faults {
 protected:
  void start() {
    const std::string storage = "_storage_dir:=" + folder_.path();
    std::vector<std::string> words{AGRID_NODE, "__name:=ending", "_storage_name:=place",
                                   "_static_map_wait:=0", storage};
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    ASSERT_EQ(posix_spawn(&process_, AGRID_NODE, nullptr, nullptr, arguments.data(), environ), 0);
    ASSERT_TRUE(test::eventually([] {
      agrid_map::GetGraph service;
      return ros::service::call("ending/get_graph", service) &&
             service.response.status.code == Status::SUCCESS;
    }));
  }
  /// Adds objects until the node is gone.
  std::set<std::string> addUntilItEnds(int client) {
    std::set<std::string> acknowledged;
    for (int i = 0;; ++i) {
      agrid_map::AddTag service;
      service.request = objectCalled(std::to_string(client) + "." + std::to_string(++count_));
      if (!ros::service::call("ending/add_tag", service)) return acknowledged;
      if (service.response.status.code == Status::SUCCESS) {
        acknowledged.insert(service.request.tag.name);
        ++acknowledged_;
      }
    }
  }
  /// @return what waitpid says
  int end(int signal) {
    kill(process_, signal);
    int status = -1;
    EXPECT_TRUE(test::eventually([&] { return waitpid(process_, &status, WNOHANG) == process_; }));
    return status;
  }

  agrid::test::TemporaryFolder folder_;
  pid_t process_ = -1;
  std::atomic<int> count_{0};
  std::atomic<int> acknowledged_{0};
};

TEST_F(Ending, L8_S3_EndedWhileItStoresItHasAllThatWasAcknowledged) {
  useTwoRooms();
  std::set<std::string> expected;
  for (const int signal : {SIGTERM, SIGINT, SIGKILL, SIGTERM, SIGINT}) {
    start();
    const int before = acknowledged_;
    std::vector<std::set<std::string>> acknowledged(8);
    std::vector<std::thread> clients;
    for (int i = 0; i < 8; ++i) {
      clients.emplace_back(
          [&, i] { acknowledged[static_cast<std::size_t>(i)] = addUntilItEnds(i); });
    }
    EXPECT_TRUE(test::eventually([&] { return acknowledged_ > before + 20; }));
    const auto begin = Clock::now();
    const int status = end(signal);
    std::printf("ended %.2f s after signal %d\n",
                std::chrono::duration<double>(Clock::now() - begin).count(), signal);
    EXPECT_EQ(signal != SIGKILL, WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    for (std::thread& client : clients) client.join();
    for (const auto& names : acknowledged) expected.insert(names.begin(), names.end());
    const agrid::StoreContents stored = agrid::readStoredMap(folder_ / "place.yaml");
    EXPECT_TRUE(stored.errors.empty());
    std::multiset<std::string> names;
    for (const auto& tag : stored.map.knowledge.objects) names.insert(tag.name);
    for (const std::string& name : expected) EXPECT_EQ(names.count(name), 1U) << name;
    EXPECT_LE(names.size(), expected.size() + 5 * clients.size())
        << "one of each may be on its way";
  }
}

}  // namespace
}  // namespace agrid_map_ros
