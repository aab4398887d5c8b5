// SPDX-License-Identifier: BSD-3-Clause
#include "tools/commands.h"

#include <algorithm>
#include <exception>
#include <iostream>

#include "agrid/map/map_io.h"
#include "agrid/storage.h"

namespace agrid::tools {
namespace {

std::vector<Command> allCommands() {
  return {convertCommand(), generateCommand(), planCommand(),   evalCommand(),
          diffCommand(),    checkCommand(),    exportCommand(), importCommand()};
}

std::string toolHelp(const std::vector<Command>& commands) {
  std::string text =
      "usage: agrid_map_tool COMMAND ...\n\nTurns metric maps into areas and doors.\n\n";
  for (const Command& command : commands) {
    std::string name = command.syntax.command;
    name.resize(10, ' ');
    text += "  " + name + command.syntax.summary + "\n";
  }
  return text +
         "\n  agrid_map_tool COMMAND --help   all about a command\n"
         "  agrid_map_tool --version        the version\n\n"
         "exit codes: 0 done, 1 failed, 2 a file cannot be read or written, 64 wrong usage\n"
         "diff and check: 0 nothing found, 1 differences or findings, 2 failed, 64 wrong usage\n";
}

int wrongUsage(const std::string& message, const std::string& usage) {
  std::cerr << "agrid_map_tool: " << message << "\n" << usage << "\n";
  return kWrongUsage;
}

int fail(const std::exception& error, int code) {
  std::cerr << "agrid_map_tool: " << error.what() << "\n";
  return code;
}

int runCommand(const Command& command, const std::vector<std::string>& words) {
  try {
    const Arguments arguments(command.syntax, words);
    if (arguments.has("help")) {
      std::cout << helpText(command.syntax);
      return kDone;
    }
    return command.run(arguments);
  } catch (const UsageError& error) {
    return wrongUsage(error.what(), usageLine(command.syntax));
  } catch (const FileError& error) {
    return fail(error, kFileFailed);
  } catch (const StorageError& error) {
    return fail(error, kFileFailed);
  } catch (const std::exception& error) {
    return fail(error, command.failed);
  }
}

int dispatch(const std::vector<std::string>& arguments) {
  const std::vector<Command> commands = allCommands();
  const std::string usage = "usage: agrid_map_tool COMMAND ... (--help lists the commands)";
  if (arguments.size() < 2) return wrongUsage("which command?", usage);
  const std::string& name = arguments[1];
  if (name == "--help" || name == "-h") {
    std::cout << toolHelp(commands);
    return kDone;
  }
  if (name == "--version") {
    std::cout << "agrid_map_tool " << AGRID_VERSION << "\n";
    return kDone;
  }
  const auto command = std::find_if(commands.begin(), commands.end(),
                                    [&](const Command& c) { return c.syntax.command == name; });
  if (command == commands.end()) return wrongUsage("unknown command '" + name + "'", usage);
  return runCommand(*command, {arguments.begin() + 2, arguments.end()});
}

}  // namespace

int run(const std::vector<std::string>& arguments) {
  const int code = dispatch(arguments);
  // A closed or full standard output loses what was asked for; success would be a lie.
  std::cout.flush();
  if (std::cout.good()) return code;
  std::cout.clear();
  std::cerr << "agrid_map_tool: cannot write to standard output\n";
  return code == kDone ? kFileFailed : code;
}

}  // namespace agrid::tools
