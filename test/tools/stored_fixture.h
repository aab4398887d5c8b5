// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include "tools/commands.h"

namespace agrid::test {

/// What a run of the tool gave back.
struct ToolRun {
  int code = 0;
  std::string out;
  std::string err;
};

inline ToolRun runTool(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "agrid_map_tool");
  std::ostringstream out;
  std::ostringstream err;
  std::streambuf* former_out = std::cout.rdbuf(out.rdbuf());
  std::streambuf* former_err = std::cerr.rdbuf(err.rdbuf());
  ToolRun result;
  result.code = tools::run(arguments);
  std::cout.rdbuf(former_out);
  std::cerr.rdbuf(former_err);
  result.out = out.str();
  result.err = err.str();
  return result;
}

/// A file as a person writes it, without checksum.
struct StoredText {
  std::string history = "00000000000000aa";
  std::vector<std::string> areas{};
  std::vector<std::string> doors{};
  std::vector<std::string> objects{};
  std::vector<std::string> pending{};

  std::string text() const {
    std::string text = "format_version: 1\nmap_id: \"m\"\nframe_id: \"map\"\nhistory: \"" +
                       history + "\"\nsequence: 0\n";
    const auto add = [&](const char* key, const std::vector<std::string>& tags) {
      text += std::string(key) + ":\n";
      for (const std::string& tag : tags) text += "  - {" + tag + "}\n";
    };
    add("areas", areas);
    add("doors", doors);
    add("objects", objects);
    add("pending", pending);
    return text + "end_of_file: true\n";
  }
};

/// An area that is a box, its seed in the middle.
inline std::string boxArea(int id, const std::string& name, double x1, double x2,
                           const std::string& more = "") {
  std::ostringstream text;
  text << "id: " << id << ", name: \"" << name << "\", seed: [" << (x1 + x2) / 2
       << ", 1.5], outline: [[" << x1 << ", 0], [" << x2 << ", 0], [" << x2 << ", 3], [" << x1
       << ", 3]]" << more;
  return text.str();
}

}  // namespace agrid::test
