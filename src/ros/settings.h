// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <XmlRpcValue.h>

#include "agrid_map_ros/parameters.h"
#include "ros/event_log.h"

namespace agrid_map_ros {

/// The parameters in use. Safe to use from several threads.
class Settings {
 public:
  /// @param ns  private namespace on the parameter server
  Settings(std::string ns, EventLog& log);

  /// Reads all parameters anew; takes all or, if one is bad, none.
  /// @return what is wrong; empty: they are taken
  std::string reload();
  /// Takes all of some values beside those on the parameter server or, if anything is bad, none.
  /// @param values  a struct
  /// @return what is wrong; empty: they are taken
  std::string change(const XmlRpc::XmlRpcValue& values);

  /// nullptr before a good set was read.
  std::shared_ptr<const Parameters> parameters() const;
  std::string error() const;  ///< of the last reload

 private:
  /// All errors as one, logged; empty if there are none.
  std::string said(const std::vector<std::string>& errors);

  std::string ns_;
  EventLog& log_;
  mutable std::mutex mutex_;
  std::shared_ptr<const Parameters> parameters_;
  std::string error_;
};

}  // namespace agrid_map_ros
