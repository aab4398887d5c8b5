// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

namespace agrid_map_ros {

/// Lets a limited number of plans run at a time.
class PlanGate {
 public:
  explicit PlanGate(int limit) : limit_(limit) {}

  /// A place inside, given back when it goes out of scope.
  class Ticket {
   public:
    explicit Ticket(PlanGate& gate) : gate_(gate), granted_(++gate.inside_ <= gate.limit_) {}
    ~Ticket() { --gate_.inside_; }
    Ticket(const Ticket&) = delete;
    Ticket& operator=(const Ticket&) = delete;
    bool granted() const { return granted_; }

   private:
    PlanGate& gate_;
    bool granted_;
  };

 private:
  int limit_;
  std::atomic<int> inside_{0};
};

}  // namespace agrid_map_ros
