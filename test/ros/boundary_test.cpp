// SPDX-License-Identifier: BSD-3-Clause
#include "ros/boundary.h"

#include <any>
#include <functional>
#include <map>
#include <new>
#include <stdexcept>
#include <string>

#include <XmlRpcException.h>
#include <boost/exception/exception.hpp>
#include <boost/lexical_cast.hpp>
#include <gtest/gtest.h>
#include <ompl/util/Exception.h>
#include <opencv2/core.hpp>
#include <ros/time.h>
#include <yaml-cpp/yaml.h>

#include "ros/diagnostics.h"
#include "ros/request_error.h"

namespace agrid_map_ros {
namespace {

using agrid_map::Status;

class Boundary : public testing::Test {
 protected:
  Boundary() { ros::Time::init(); }
  EventLog log_;
};

TEST_F(Boundary, L10_WhateverIsThrownIsCaughtAndCounted) {
  struct NoStandardException : boost::exception {};
  const std::map<std::string, std::function<void()>> throwers{
      {"std", [] { throw std::runtime_error("hidden reason"); }},
      {"logic", [] { std::string().at(7); }},
      {"memory", [] { throw std::bad_alloc(); }},
      {"any", [] { std::any_cast<int>(std::any("text")); }},
      {"cv", [] { cv::Mat(2, 2, CV_8U).reshape(3, 5); }},
      {"yaml", [] { YAML::Load("[1, 2").as<int>(); }},
      {"xmlrpc", [] { throw XmlRpc::XmlRpcException("type error"); }},
      {"ompl", [] { throw ompl::Exception("planner", "no goal"); }},
      {"boost", [] { boost::lexical_cast<int>("x"); }},
      {"boost without std", [] { throw NoStandardException(); }},
      {"number", [] { throw 42; }}};
  std::uint64_t count = 0;
  for (const auto& [name, thrower] : throwers) {
    const auto failure = attempt(log_, "test", thrower);
    ASSERT_TRUE(failure) << name;
    EXPECT_NE(failure->code, Status::SUCCESS) << name;
    EXPECT_FALSE(failure->message.empty()) << name;
    EXPECT_EQ(log_.caughtCount(), ++count) << name;
    EXPECT_NE(log_.lastError().find(failure->message), std::string::npos) << name;
  }
  const auto status = diagnose({}, log_);
  EXPECT_EQ(status.values.at(status.values.size() - 2).value, std::to_string(throwers.size()));
}

TEST_F(Boundary, L10_ARefusalIsNoUnexpectedException) {
  const auto failure =
      attempt(log_, "test", [] { throw RequestError(Status::NAME_TAKEN, "it is called so"); });
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->code, Status::NAME_TAKEN);
  EXPECT_EQ(failure->message, "it is called so");
  EXPECT_TRUE(attempt(log_, "test", [] { throw std::invalid_argument("width is -1"); }));
  EXPECT_EQ(log_.caughtCount(), 0U);
}

TEST_F(Boundary, WhatRunsToItsEndIsNoFailure) {
  bool ran = false;
  EXPECT_FALSE(attempt(log_, "test", [&ran] { ran = true; }));
  EXPECT_TRUE(ran);
  EXPECT_EQ(log_.errorCount(), 0U);
}

}  // namespace
}  // namespace agrid_map_ros
