// SPDX-License-Identifier: BSD-3-Clause
#include "ros/request_queue.h"

#include <atomic>
#include <future>
#include <map>
#include <memory>
#include <set>

#include <gtest/gtest.h>

namespace agrid_map_ros {
namespace {

constexpr double kForever = 3600;

/// Requests of one client; each tells its turn, and those that are answered take until `open`.
class RequestQueueTest : public testing::Test {
 protected:
  class Request : public ros::CallbackInterface {
   public:
    Request(RequestQueueTest& test, const RequestQueue& queue) : test_(test), queue_(queue) {}
    CallResult call() override {
      const RequestQueue::Call call = queue_.current();
      test_.note(call);
      if (call.turn == Turn::kAnswer) test_.opened_.wait();
      ++test_.done_;
      return Success;
    }

   private:
    RequestQueueTest& test_;
    const RequestQueue& queue_;
  };

  void add(RequestQueue& queue, int count, std::uint64_t owner = 1) {
    for (int i = 0; i < count; ++i) {
      queue.addCallback(boost::make_shared<Request>(*this, queue), owner);
    }
  }
  void note(const RequestQueue::Call& call) {
    const std::lock_guard<std::mutex> lock(mutex_);
    ++turns_[call.turn];
    longest_wait_ = std::max(longest_wait_, call.waited);
    threads_.insert(std::this_thread::get_id());
    changed_.notify_all();
  }
  /// Waits until so many have had this turn.
  void expect(Turn turn, int count) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait_for(lock, std::chrono::seconds(60), [&] { return turns_[turn] >= count; });
    EXPECT_EQ(turns_[turn], count);
  }
  void open() { open_.set_value(); }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<Turn, int> turns_;
  std::set<std::thread::id> threads_;
  RequestQueue::Clock::duration longest_wait_{};
  std::atomic<int> done_{0};
  std::promise<void> open_;
  std::shared_future<void> opened_{open_.get_future()};
};

TEST_F(RequestQueueTest, P13_SomeRunSomeWaitAndTheRestIsRefusedAtOnceByOneThread) {
  RequestQueue queue({2, 100}, [] { return kForever; });
  add(queue, 2);
  expect(Turn::kAnswer, 2);
  add(queue, 998);
  expect(Turn::kBusy, 1000 - 2 - 100);  // while the two are still at it
  EXPECT_EQ(turns_[Turn::kAnswer], 2);
  EXPECT_EQ(threads_.size(), 3U);
  open();
  expect(Turn::kAnswer, 102);
  EXPECT_EQ(threads_.size(), 3U);
  EXPECT_EQ(turns_[Turn::kLate], 0);
}

TEST_F(RequestQueueTest, P13_WithoutALineAllBeyondThoseThatRunAreRefused) {
  RequestQueue queue({1, 0}, [] { return kForever; });
  add(queue, 1);
  expect(Turn::kAnswer, 1);
  add(queue, 3);
  expect(Turn::kBusy, 3);
  open();
}

TEST_F(RequestQueueTest, P10_NoneWaitsLongerThanItMay) {
  RequestQueue queue({1, 100}, [] { return 0.02; });
  add(queue, 1);
  expect(Turn::kAnswer, 1);
  add(queue, 5);
  expect(Turn::kLate, 5);
  EXPECT_GE(longest_wait_, std::chrono::milliseconds(20));
  open();
}

TEST_F(RequestQueueTest, P14_FinishAnswersThoseThatWaitAndEndsAllThreads) {
  RequestQueue queue({1, 100}, [] { return kForever; });
  add(queue, 1);
  expect(Turn::kAnswer, 1);
  add(queue, 5);
  auto finished = std::async(std::launch::async, [&] { queue.finish(); });
  expect(Turn::kCancelled, 5);
  EXPECT_EQ(finished.wait_for(std::chrono::milliseconds(20)), std::future_status::timeout);
  open();
  finished.get();
  EXPECT_EQ(done_, 6);
  add(queue, 1);
  queue.finish();
  EXPECT_EQ(done_, 6);
}

TEST_F(RequestQueueTest, P14_ThoseOfAnOwnerThatIsGoneAreDropped) {
  RequestQueue queue({1, 100}, [] { return kForever; });
  add(queue, 1);
  expect(Turn::kAnswer, 1);
  add(queue, 5, 2);
  add(queue, 3, 3);
  queue.removeByID(2);
  open();
  expect(Turn::kAnswer, 4);
  queue.finish();
  EXPECT_EQ(done_, 4);
}

}  // namespace
}  // namespace agrid_map_ros
