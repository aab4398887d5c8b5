// SPDX-License-Identifier: BSD-3-Clause
// Clients that edit a store as fast as they can, for kill_loop.py and power_cut.py.
//
// run DIRECTORY [--early] [--no-sync]   prints 'CLIENT COUNT' for every edit that is stored, and
//                                       'ready' first, until it is killed
// check DIRECTORY                       prints 'CLIENT COUNT' of each client's last stored edit;
//                                       exit code 1 if one is there in part or the store is damaged
// latency DIRECTORY THREADS EDITS       prints how long EDITS edits take
//
// --early acknowledges before storing, --no-sync leaves out fsync: what the checkers must detect.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include <sys/syscall.h>
#include <unistd.h>

#include "agrid/storage.h"
#include "storage/batched_writer.h"
#include "storage/hammer_edits.h"

namespace {

std::atomic<bool> is_synced{true};

}  // namespace

// These stand in front of the C library's.
extern "C" int fsync(int fd) { return is_synced ? static_cast<int>(syscall(SYS_fsync, fd)) : 0; }
extern "C" int fdatasync(int fd) {
  return is_synced ? static_cast<int>(syscall(SYS_fdatasync, fd)) : 0;
}

namespace {

using agrid::Change;
using agrid::Store;
using agrid::StoreContents;
using agrid::StoredMap;
using agrid::test::BatchedWriter;
using Clock = std::chrono::steady_clock;

constexpr std::size_t kFoldEvery = 300;  // edits
constexpr const char* kName = "hammer";

[[noreturn]] void die(const std::string& what) {
  std::cerr << what << std::endl;
  _exit(1);
}

void report(const StoreContents& contents) {
  for (const std::string& error : contents.errors) std::cerr << "error: " << error << '\n';
  for (const std::string& warning : contents.warnings) std::cerr << "warning: " << warning << '\n';
}

void say(const std::string& line) {
  if (write(STDOUT_FILENO, line.data(), line.size()) < 0) die("nobody listens");
}

/// A store with what it holds.
class Place {
 public:
  explicit Place(const std::string& directory) : store_(directory, kName) {
    StoreContents contents = store_.takeContents();
    report(contents);
    if (!contents.errors.empty()) die("damaged");
    map_ = std::move(contents.map);
    store_.fold(map_);
  }

  const StoredMap& map() const { return map_; }

  void write(const BatchedWriter::Edits& edits) {
    try {
      store_.append(edits);
      for (const auto& edit : edits) {
        for (const Change& change : edit) agrid::apply(change, map_.knowledge);
      }
      since_fold_ += edits.size();
      if (since_fold_ < kFoldEvery) return;
      store_.fold(map_);
      since_fold_ = 0;
    } catch (const std::exception& error) {
      die(error.what());
    }
  }

 private:
  Store store_;
  StoredMap map_;
  std::size_t since_fold_ = 0;
};

int run(const std::string& directory, bool early) {
  Place place(directory);
  auto counts = agrid::test::hammerCounts(place.map().knowledge);
  BatchedWriter writer([&](const BatchedWriter::Edits& edits) { place.write(edits); });
  say("ready\n");
  std::vector<std::thread> clients;
  for (std::uint32_t client = 0; client < agrid::test::kClients; ++client) {
    clients.emplace_back([&writer, early, client, count = counts[client]]() mutable {
      for (;;) {
        const std::string line = std::to_string(client) + " " + std::to_string(++count) + "\n";
        if (early) say(line);
        writer.append(agrid::test::hammerEdit(client, count));
        if (!early) say(line);
      }
    });
  }
  for (std::thread& client : clients) client.join();
  return 0;
}

int check(const std::string& directory) {
  Store store(directory, kName);
  const StoreContents contents = store.takeContents();
  report(contents);
  for (const auto& [client, count] : agrid::test::hammerCounts(contents.map.knowledge)) {
    std::cout << client << ' ' << count << '\n';
  }
  return contents.errors.empty() ? 0 : 1;
}

int latency(const std::string& directory, std::size_t threads, std::size_t edits) {
  Store store(directory, kName);
  BatchedWriter writer([&](const BatchedWriter::Edits& batch) { store.append(batch); });
  std::vector<std::vector<double>> took_ms(threads);
  std::vector<std::thread> clients;
  const auto start = Clock::now();
  for (std::size_t client = 0; client < threads; ++client) {
    clients.emplace_back([&, client] {
      for (std::uint32_t n = 1; n <= edits / threads; ++n) {
        const auto before = Clock::now();
        writer.append(agrid::test::hammerEdit(static_cast<std::uint32_t>(client), n));
        const std::chrono::duration<double, std::milli> took = Clock::now() - before;
        took_ms[client].push_back(took.count());
      }
    });
  }
  for (std::thread& client : clients) client.join();
  const std::chrono::duration<double> whole = Clock::now() - start;
  std::vector<double> all;
  for (const auto& some : took_ms) all.insert(all.end(), some.begin(), some.end());
  std::sort(all.begin(), all.end());
  const auto share = [&](std::size_t percent) { return all[(all.size() - 1) * percent / 100]; };
  std::printf("%zu threads: %.0f edits/s, median %.2f ms, 99 %% within %.2f ms, worst %.2f ms\n",
              threads, static_cast<double>(all.size()) / whole.count(), share(50), share(99),
              share(100));
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const auto has = [&](const char* word) {
    return std::find(words.begin(), words.end(), word) != words.end();
  };
  is_synced = !has("--no-sync");
  try {
    if (words.size() >= 2 && words[0] == "run") return run(words[1], has("--early"));
    if (words.size() == 2 && words[0] == "check") return check(words[1]);
    if (words.size() == 4 && words[0] == "latency") {
      return latency(words[1], std::stoul(words[2]), std::stoul(words[3]));
    }
  } catch (const std::exception& error) {
    die(error.what());
  }
  std::cerr << "usage: run|check|latency DIRECTORY ...\n";
  return 64;
}
