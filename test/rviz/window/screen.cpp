// SPDX-License-Identifier: BSD-3-Clause
#include "screen.h"

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace agrid_map_rviz::test {

Screen::Screen() {
  std::string pattern = std::filesystem::temp_directory_path() / "agrid_rviz_XXXXXX";
  if (!mkdtemp(pattern.data())) throw std::runtime_error("no folder for the test's files");
  folder_ = pattern;
  int pipe_ends[2];
  if (pipe(pipe_ends) != 0) throw std::runtime_error("no pipe");
  server_ = fork();
  if (server_ == 0) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    const std::string descriptor = std::to_string(pipe_ends[1]);
    execlp("Xvfb", "Xvfb", "-displayfd", descriptor.c_str(), "-screen", "0", "1400x900x24",
           "-nolisten", "tcp", "-noreset", static_cast<char*>(nullptr));
    _exit(127);
  }
  close(pipe_ends[1]);
  // the server writes the number of its display when it is up
  std::string display = ":";
  for (char c = 0; read(pipe_ends[0], &c, 1) == 1 && c != '\n';) display += c;
  close(pipe_ends[0]);
  if (display == ":") throw std::runtime_error("Xvfb did not start");
  setenv("DISPLAY", display.c_str(), 1);
  setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
  setenv("QT_X11_NO_MITSHM", "1", 1);
  setenv("QT_QPA_PLATFORM", "xcb", 1);
  setenv("XDG_RUNTIME_DIR", folder_.c_str(), 1);
  setenv("HOME", folder_.c_str(), 1);
}

Screen::~Screen() {
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
}

}  // namespace agrid_map_rviz::test
