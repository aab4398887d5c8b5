// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace agrid::test {

/// While this is in scope, the system calls that a store makes are counted, and one or more of them
/// do something else instead: `failing_calls_test.cpp` stands in front of the C library's.
class WatchedCalls {
 public:
  enum class Then {
    kSucceed,    ///< all calls are only noted
    kFail,       ///< the call with the given number fails, once
    kFailOn,     ///< ... and all later ones
    kEndProcess  ///< the process ends before that call, a write half done
  };

  /// @param number  of the call, from 1
  WatchedCalls(Then then, int number = 0, int error = 0);
  WatchedCalls(const WatchedCalls&) = delete;
  WatchedCalls& operator=(const WatchedCalls&) = delete;
  ~WatchedCalls();

  /// Whether the call was reached.
  bool wasReached() const;
  /// The names of the calls, in their order.
  const std::vector<std::string>& names() const;
};

}  // namespace agrid::test
