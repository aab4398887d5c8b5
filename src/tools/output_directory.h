// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "opencv2/core.hpp"

namespace agrid::tools {

/// Files that appear in a directory when all of them are written, or not at all: they are written
/// beside their place and renamed. The directory is made if it is missing, its parent is not.
class OutputDirectory {
 public:
  /// @param files  names of the files to be written
  /// @throws UsageError if one of the files is there already and may not be replaced
  /// @throws FileError if nothing can be written there
  OutputDirectory(const std::string& path, const std::vector<std::string>& files, bool replace);
  /// Removes what was not published.
  ~OutputDirectory();
  OutputDirectory(const OutputDirectory&) = delete;
  OutputDirectory& operator=(const OutputDirectory&) = delete;

  /// Where to write a file until publish().
  /// @throws FileError if the place cannot be made
  std::string stagedPath(const std::string& file);
  /// Puts the files in their place. @throws FileError
  void publish();

 private:
  void stage();

  std::string path_;
  std::string staging_;
  std::vector<std::string> files_;
};

/// @throws FileError
void writeText(const std::string& path, const std::string& text);
/// Writes an 8- or 16-bit PNG. @throws FileError
void writePng(const std::string& path, const cv::Mat& image);

}  // namespace agrid::tools
