// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>

#include <fcntl.h>

#include "tools/commands.h"

namespace {

/// A file that the tool opens must not get the number of a closed standard stream: what is meant
/// for the stream would end up in the file.
void occupyStandardStreams() {
  while (true) {
    const int descriptor = open("/dev/null", O_RDONLY);
    if (descriptor < 0 || descriptor > 2) break;
  }
}

}  // namespace

int main(int argc, char** argv) {
  occupyStandardStreams();
  // A reader that went away shows as a failed write, not as a dead process and files half written.
  std::signal(SIGPIPE, SIG_IGN);
  return agrid::tools::run({argv, argv + argc});
}
