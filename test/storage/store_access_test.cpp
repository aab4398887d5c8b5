// SPDX-License-Identifier: BSD-3-Clause
#include <csignal>

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "storage/stored_place.h"
#include "support/temporary_folder.h"

namespace agrid {
namespace {

namespace fs = std::filesystem;

using test::codeOf;
using test::contentsOf;
using test::foundIn;
using test::storedIn;
using test::TemporaryFolder;

mode_t modeOf(const std::string& path) {
  struct stat status {};
  return stat(path.c_str(), &status) == 0 ? status.st_mode & 07777U : 0;
}

TEST(Store, S8_OneProcessAtATimeAndAKilledOneIsOutOfTheWay) {
  const TemporaryFolder folder;
  int ready[2];
  ASSERT_EQ(pipe(ready), 0);
  const pid_t child = fork();
  if (child == 0) {
    const Store store(folder.path(), "office");
    if (write(ready[1], "x", 1) != 1) _exit(1);
    pause();
  }
  char byte = 0;
  ASSERT_EQ(read(ready[0], &byte, 1), 1);
  EXPECT_EQ(codeOf([&] { Store(folder.path(), "office"); }), StorageErrorCode::kLocked);
  EXPECT_NO_THROW(Store(folder.path(), "office", {true, true}));
  EXPECT_NO_THROW(Store(folder.path(), "other"));
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
  EXPECT_NO_THROW(Store(folder.path(), "office"));
  close(ready[0]);
  close(ready[1]);
}

TEST(Store, S9_SymbolicLinksAreRefused) {
  const TemporaryFolder folder;
  const std::string victim = folder.write("victim", "precious");
  for (const std::string file : {"a.yaml", "b.lock", "c.yaml.bak", "d.journal-1"}) {
    fs::create_symlink(victim, folder / file);
    EXPECT_EQ(codeOf([&] { Store(folder.path(), file.substr(0, 1)); }), StorageErrorCode::kPath);
  }
  fs::create_directory(folder / "e.yaml");
  EXPECT_EQ(codeOf([&] { Store(folder.path(), "e"); }), StorageErrorCode::kPath);
  ASSERT_EQ(mkfifo((folder / "f.yaml").c_str(), 0600), 0);
  EXPECT_EQ(codeOf([&] { Store(folder.path(), "f"); }), StorageErrorCode::kPath);
  EXPECT_EQ(contentsOf(victim), "precious");
}

TEST(Store, S10_FilesAreForTheirOwnerOnlyWhateverTheUmaskIs) {
  for (const mode_t mask : {0, 0777}) {
    const TemporaryFolder folder;
    const mode_t former = umask(mask);
    if (mask == 0) {
      storedIn(folder / "deep/er");
      EXPECT_EQ(modeOf(folder / "deep"), 0700U);
      EXPECT_EQ(modeOf(folder / "deep/er"), 0700U);
      EXPECT_EQ(modeOf(folder / "deep/er/office.yaml"), 0600U);
      EXPECT_EQ(modeOf(folder / "deep/er/office.journal-1"), 0600U);
      EXPECT_EQ(modeOf(folder / "deep/er/office.lock"), 0600U);
    } else {
      storedIn(folder.path());
      EXPECT_EQ(modeOf(folder / "office.yaml"), 0600U);
    }
    umask(former);
  }
  const TemporaryFolder open_to_all;
  ASSERT_EQ(chmod(open_to_all.path().c_str(), 0777), 0);
  const auto warnings = foundIn(open_to_all.path()).warnings;
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("everybody may write"), std::string::npos);
}

TEST(Store, S11_OnlyPlainNamesAreTaken) {
  for (const char* name : {"a", "A-1_b.c", "0", "_", "-"}) EXPECT_EQ(checkedName(name), name);
  EXPECT_NO_THROW(checkedName(std::string(64, 'x')));
  for (const std::string& name :
       {std::string(), std::string(65, 'x'), std::string("."), std::string(".."), std::string(".a"),
        std::string("a/b"), std::string("../a"), std::string("/etc/passwd"), std::string("a b"),
        std::string("a\0b", 3), std::string("a\n"), std::string("caf\u00e9"), std::string(";id;"),
        std::string("~"), std::string("$HOME"), std::string("*")}) {
    EXPECT_EQ(codeOf([&] { checkedName(name); }), StorageErrorCode::kPath);
  }
  const TemporaryFolder folder;
  const StoredMap map = storedIn(folder.path());
  const Store store(folder.path(), "office");
  EXPECT_EQ(codeOf([&] { store.saveAs("../x", map); }), StorageErrorCode::kPath);
  EXPECT_EQ(codeOf([&] { store.loadFrom("../x"); }), StorageErrorCode::kPath);
  EXPECT_EQ(codeOf([&] { store.loadFrom("none"); }), StorageErrorCode::kPath);
  EXPECT_FALSE(fs::exists(folder / "none.lock"));
}

TEST(Store, OtherFilesLieBesideItAndNeverInItsPlace) {
  const TemporaryFolder folder;
  Store store(folder.path(), "office");
  store.saveBeside("office.svg", "old");
  store.saveBeside("office.svg", std::string("a\0b", 3));
  EXPECT_EQ(contentsOf(folder / "office.svg"), std::string("a\0b", 3));
  EXPECT_EQ(modeOf(folder / "office.svg"), 0600U);
  for (const char* name : {"../a.svg", "/tmp/a.svg", ".svg", "office.yaml", "office.yaml.bak",
                           "office.journal-1", "office.lock"}) {
    EXPECT_EQ(codeOf([&] { store.saveBeside(name, ""); }), StorageErrorCode::kPath) << name;
  }
  fs::create_symlink("/dev/null", folder / "link.svg");
  store.saveBeside("link.svg", "x");
  EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(folder / "link.svg")));
  StoreOptions options;
  options.read_only = true;
  const Store reader(folder.path(), "office", options);
  EXPECT_EQ(codeOf([&] { reader.saveBeside("b.svg", ""); }), StorageErrorCode::kReadOnly);
  EXPECT_FALSE(fs::exists(folder / "b.svg"));
}

TEST(Store, S14_OnlyItsOwnTemporaryFilesAreRemoved) {
  const TemporaryFolder folder;
  folder.write(".office.tmp-0123456789abcdef", "left by a killed process");
  folder.write(".office.tmp-0123456789abcdeX", "not ours");
  folder.write(".other.tmp-0123456789abcdef", "of another map");
  folder.write("office.tmp-0123456789abcdef", "a person's");
  foundIn(folder.path());
  EXPECT_FALSE(fs::exists(folder / ".office.tmp-0123456789abcdef"));
  EXPECT_TRUE(fs::exists(folder / ".office.tmp-0123456789abcdeX"));
  EXPECT_TRUE(fs::exists(folder / ".other.tmp-0123456789abcdef"));
  EXPECT_TRUE(fs::exists(folder / "office.tmp-0123456789abcdef"));
}

}  // namespace
}  // namespace agrid
