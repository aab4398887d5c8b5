// SPDX-License-Identifier: BSD-3-Clause
#include "tools/output_directory.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <sys/stat.h>
#include <unistd.h>

#include "agrid/map/map_io.h"
#include "opencv2/imgcodecs.hpp"
#include "tools/arguments.h"

namespace agrid::tools {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw FileError(FileErrorCode::kIo, path + ": " + why);
}

/// The directory that a path's last name lies in.
std::string parentOf(const std::string& path) {
  const std::string parent = fs::path(path).parent_path().string();
  return parent.empty() ? "." : parent;
}

std::string withoutTrailingSlashes(std::string path) {
  while (path.size() > 1 && path.back() == '/') path.pop_back();
  return path;
}

/// mkdtemp gives a directory to its owner alone; results are as open as any other file.
void openToUmask(const std::string& path) {
  const mode_t mask = umask(0);
  umask(mask);
  chmod(path.c_str(), 0777 & ~mask);
}

void writeBytes(const std::string& path, const char* data, std::size_t size) {
  std::ofstream file(path, std::ios::binary | std::ios::trunc);
  file.write(data, static_cast<std::streamsize>(size));
  file.close();
  if (!file) refuse(path, std::string("cannot be written: ") + std::strerror(errno));
}

}  // namespace

OutputDirectory::OutputDirectory(const std::string& path, const std::vector<std::string>& files,
                                 bool replace)
    : path_(withoutTrailingSlashes(path)), files_(files) {
  if (path_.empty()) throw UsageError("the output directory's name is empty");
  std::error_code error;
  const fs::file_status status = fs::status(path_, error);
  const bool exists = fs::exists(status);
  if (exists && !fs::is_directory(status)) refuse(path_, "is not a directory");
  const std::string place = exists ? path_ : parentOf(path_);
  if (access(place.c_str(), W_OK | X_OK) != 0) {
    refuse(place, std::string("cannot be written into: ") + std::strerror(errno));
  }
  if (!exists && !fs::is_directory(place, error)) refuse(place, "is not a directory");
  if (replace) return;
  for (const std::string& file : files_) {
    if (fs::exists(fs::symlink_status(fs::path(path_) / file, error))) {
      throw UsageError((fs::path(path_) / file).string() + " exists; --force replaces it");
    }
  }
}

OutputDirectory::~OutputDirectory() {
  std::error_code error;
  if (!staging_.empty()) fs::remove_all(staging_, error);
}

void OutputDirectory::stage() {
  std::error_code error;
  const std::string place = fs::is_directory(path_, error) ? path_ : parentOf(path_);
  std::string name = place + "/.agrid_map_tool.XXXXXX";
  if (!mkdtemp(name.data()))
    refuse(place, std::string("cannot be written into: ") + std::strerror(errno));
  staging_ = name;
}

std::string OutputDirectory::stagedPath(const std::string& file) {
  if (staging_.empty()) stage();
  return staging_ + "/" + file;
}

void OutputDirectory::publish() {
  if (staging_.empty()) stage();
  std::error_code error;
  if (!fs::exists(path_, error)) {
    openToUmask(staging_);
    fs::rename(staging_, path_, error);
    if (error) refuse(path_, "cannot be made: " + error.message());
    staging_.clear();
    return;
  }
  for (const std::string& file : files_) {
    fs::rename(stagedPath(file), fs::path(path_) / file, error);
    if (error) refuse((fs::path(path_) / file).string(), "cannot be written: " + error.message());
  }
}

void writeText(const std::string& path, const std::string& text) {
  writeBytes(path, text.data(), text.size());
}

void writePng(const std::string& path, const cv::Mat& image) {
  std::vector<unsigned char> bytes;
  if (!cv::imencode(".png", image, bytes)) refuse(path, "cannot be encoded as PNG");
  writeBytes(path, reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

}  // namespace agrid::tools
