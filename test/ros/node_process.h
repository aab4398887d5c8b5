// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <fstream>
#include <string>

#include <XmlRpcClient.h>
#include <ros/master.h>
#include <ros/network.h>
#include <ros/this_node.h>
#include <sys/types.h>

namespace agrid_map_ros::test {

/// The id of a node's process; -1 if it does not answer.
inline pid_t processOf(const std::string& node) {
  XmlRpc::XmlRpcValue request;
  XmlRpc::XmlRpcValue response;
  XmlRpc::XmlRpcValue uri;
  request[0] = ros::this_node::getName();
  request[1] = node;
  if (!ros::master::execute("lookupNode", request, response, uri, false)) return -1;
  std::string host;
  std::uint32_t port = 0;
  if (!ros::network::splitURI(uri, host, port)) return -1;
  XmlRpc::XmlRpcClient client(host.c_str(), static_cast<int>(port), "/");
  XmlRpc::XmlRpcValue own_name;
  own_name[0] = ros::this_node::getName();
  if (!client.execute("getPid", own_name, response)) return -1;
  return static_cast<int>(response[2]);
}

/// What a process has in memory [kB], or the most that it had ("VmHWM:"); 0 if there is none.
inline long kilobytesOf(pid_t process, const std::string& field = "VmRSS:") {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string word; status >> word;) {
    long kilobytes = 0;
    if (word == field && status >> kilobytes) return kilobytes;
  }
  return 0;
}

}  // namespace agrid_map_ros::test
