// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "tools/arguments.h"

namespace agrid::tools {

/// Exit codes of the tool.
constexpr int kDone = 0;
constexpr int kFailed = 1;
constexpr int kFound = 1;  ///< of commands that look for something, as diff does
constexpr int kFileFailed = 2;
constexpr int kWrongUsage = 64;

/// A command of the tool: what it takes, and what does it.
struct Command {
  Syntax syntax;
  /// Returns the exit code; throws UsageError, FileError or any other exception where it fails.
  std::function<int(const Arguments&)> run;
  int failed = kFailed;  ///< exit code where it fails but not on a file
};

Command checkCommand();     ///< tells what is wrong with stored tags
Command convertCommand();   ///< map -> areas, doors, graph and their pictures
Command diffCommand();      ///< tells what differs between stored tags
Command evalCommand();      ///< scores areas and doors against rooms drawn by people
Command exportCommand();    ///< map -> files of other programs
Command generateCommand();  ///< draws an office
Command importCommand();    ///< files of other programs -> stored tags
Command planCommand();      ///< answers start-goal pairs

/// Runs the command line tool. Results go to standard output, all else to standard error.
/// @param arguments  as main's, the program's name first
/// @return the exit code: 0 done, 1 failed, or differences or findings, 2 a file cannot be read or
///         written, 64 wrong usage
int run(const std::vector<std::string>& arguments);

}  // namespace agrid::tools
