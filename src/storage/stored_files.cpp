// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <optional>

#include "agrid/storage.h"
#include "map/printable.h"
#include "storage/directory.h"
#include "storage/recovery.h"
#include "storage/snapshot.h"

namespace agrid {
namespace {

constexpr int kAttempts = 10;
constexpr const char* kEnding = ".yaml";

/// The name of the stored map whose snapshot a file is, by its own name.
std::optional<std::string> storeName(const std::string& file) {
  const std::size_t dot = file.rfind(kEnding);
  if (dot == std::string::npos || dot + std::string(kEnding).size() != file.size()) return {};
  try {
    return checkedName(file.substr(0, dot));
  } catch (const StorageError&) {
    return std::nullopt;
  }
}

StoreContents readFile(const Directory& directory, const std::string& file) {
  const auto contents = directory.read(file);
  if (!contents) {
    throw StorageError(StorageErrorCode::kPath, directory.pathOf(file) + ": there is no such file");
  }
  ReadSnapshot read = readSnapshot(contents->text, directory.pathOf(file));
  return {std::move(read.snapshot.map), false, {}, std::move(read.warnings), read.snapshot.history};
}

/// The process that holds the store may fold meanwhile; then all is read again.
Recovered readUnchanged(const Directory& directory, const StoreFiles& files) {
  Recovered found;
  for (int attempt = 0; attempt < kAttempts; ++attempt) {
    const auto before = directory.identityOf(files.snapshot);
    found = recover(directory, files, false);
    if (directory.identityOf(files.snapshot) == before) break;
  }
  return found;
}

}  // namespace

const std::string& checkedName(const std::string& name) {
  const auto is_allowed = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '.' || c == '-';
  };
  if (!name.empty() && name.size() <= 64 && name[0] != '.' &&
      std::all_of(name.begin(), name.end(), is_allowed)) {
    return name;
  }
  throw StorageError(StorageErrorCode::kPath,
                     "'" + printable(name.substr(0, 80)) +
                         "' is no name of a stored map: 1 to 64 " +
                         "of A-Z a-z 0-9 _ . - are allowed, no dot in front");
}

StoreContents readStoredMap(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  const std::string file = slash == std::string::npos ? path : path.substr(slash + 1);
  const Directory directory(slash == std::string::npos ? "." : path.substr(0, slash + 1), false);
  const auto name = storeName(file);
  if (!name) return readFile(directory, file);
  Recovered found = readUnchanged(directory, StoreFiles(*name));
  if (found.contents.is_new) {
    throw StorageError(StorageErrorCode::kPath, directory.pathOf(file) + ": there is no such file");
  }
  if (found.snapshot_bytes == 0 && !found.contents.errors.empty()) {
    throw StorageError(StorageErrorCode::kCorrupt, found.contents.errors.front());
  }
  found.contents.history = found.history;
  return std::move(found.contents);
}

}  // namespace agrid
