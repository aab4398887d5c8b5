// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include "map/file_reader.h"
#include "map/printable.h"
#include "support/map_files.h"

namespace agrid {
namespace {

namespace fs = std::filesystem;
using test::expectFileError;
using test::MapFolder;
using test::mapYaml;
using test::smallPgm;

void expectPathError(const std::string& part, const std::string& yaml_path,
                     const MapFileParams& params = {}) {
  SCOPED_TRACE(yaml_path.substr(0, 200));
  expectFileError(FileErrorCode::kPath, part, [&] { loadMap(yaml_path, params); });
}

void expectImagePathError(const std::string& part, const std::string& image) {
  const MapFolder folder(smallPgm(), mapYaml("image: " + image));
  expectPathError(part, folder.path("map.yaml"));
}

MapFileParams only(const std::string& map_dir) {
  MapFileParams params;
  params.map_dir = map_dir;
  return params;
}

TEST(MapFile, F1_MissingFiles) {
  expectPathError("No such file", "/nonexistent/map.yaml");
  expectImagePathError("No such file", "nothere.png");
  expectPathError("path is empty", "");
}

TEST(MapFile, F1_NoPermission) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read every file";
  const MapFolder folder;
  fs::permissions(folder.path("map.img"), fs::perms::none);
  expectPathError("Permission denied", folder.path("map.yaml"));
}

TEST(MapFile, F2_WhatIsNoRegularFileIsNotWaitedFor) {
  const MapFolder folder;
  ASSERT_EQ(mkfifo(folder.path("fifo").c_str(), 0600), 0);
  const int listener = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  folder.path("socket").copy(address.sun_path, sizeof address.sun_path - 1);
  ASSERT_EQ(bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  for (const std::string& path : {folder.path(), folder.path("fifo"), folder.path("socket"),
                                  std::string("/dev/zero"), std::string("/dev/null")}) {
    expectPathError("not a regular file", path);
    expectImagePathError("not a regular file", path);
  }
  close(listener);
}

TEST(MapFile, F10_ImageIsRelativeToTheYaml) {
  const MapFolder folder;
  fs::create_directories(folder.path("sub/images"));
  folder.write("sub/images/i.pgm", smallPgm());
  folder.write("sub/m.yaml", mapYaml("image: images/i.pgm"));
  EXPECT_EQ(loadMap(folder.path("sub/m.yaml")).grid.values.size(), 3u);
  const fs::path before = fs::current_path();
  fs::current_path(folder.path("sub"));
  EXPECT_EQ(loadMap("m.yaml").grid.values.size(), 3u);
  fs::current_path(before);
}

TEST(MapFile, F11_AbsolutePathsAndThoseAboveOnlyWithoutMapDir) {
  const MapFolder outside;
  const MapFolder folder;
  const std::string absolute =
      folder.write("absolute.yaml", mapYaml("image: " + outside.path("map.img")));
  const std::string above = folder.write(
      "above.yaml",
      mapYaml("image: ../" + fs::path(outside.path()).filename().string() + "/map.img"));
  for (const std::string& path : {absolute, above}) {
    EXPECT_EQ(loadMap(path).grid.values.size(), 3u);
    expectPathError("not under map_dir", path, only(folder.path()));
  }
  expectPathError("not under map_dir", outside.path("map.yaml"), only(folder.path()));
  expectPathError("not under map_dir", folder.path() + "/../x.yaml", only(folder.path()));
  EXPECT_EQ(folder.load(only(folder.path())).grid.values.size(), 3u);
  EXPECT_EQ(folder.load(only(folder.path() + "/")).grid.values.size(), 3u);
  EXPECT_EQ(folder.load(only("/")).grid.values.size(), 3u);
  const std::string inside = folder.write("in.yaml", mapYaml("image: " + folder.path("map.img")));
  EXPECT_EQ(loadMap(inside, only(folder.path())).grid.values.size(), 3u);
}

TEST(MapFile, F11_AFolderWhoseNameBeginsAlikeIsOutside) {
  const test::TemporaryFolder folder;
  fs::create_directory(folder.path("maps"));
  fs::create_directory(folder.path("maps2"));
  folder.write("maps2/map.img", smallPgm());
  folder.write("maps2/map.yaml", mapYaml());
  expectPathError("not under map_dir", folder.path("maps2/map.yaml"), only(folder.path("maps")));
}

TEST(MapFile, F11_TheAnswerDoesNotTellWhatExistsOutside) {
  const MapFolder outside;
  const MapFolder folder;
  std::vector<std::string> answers;
  for (const std::string name : {"map.yaml", "nope.yaml"}) {
    try {
      loadMap(outside.path(name), only(folder.path()));
    } catch (const FileError& error) {
      answers.push_back(std::string(error.what()).substr(outside.path(name).size()));
    }
  }
  ASSERT_EQ(answers.size(), 2u);
  EXPECT_EQ(answers[0], answers[1]);
}

TEST(MapFile, F11_MapDirMustExist) {
  const MapFolder folder;
  expectPathError("map_dir cannot be used", folder.path("map.yaml"), only("/nonexistent"));
}

TEST(MapFile, F12_LinksAreFollowedButNotOutOfMapDir) {
  const MapFolder outside;
  const MapFolder folder;
  fs::create_symlink(outside.path("map.yaml"), folder.path("out.yaml"));
  fs::create_symlink(outside.path("map.img"), folder.path("out.img"));
  fs::create_symlink(folder.path("map.yaml"), folder.path("in.yaml"));
  fs::create_directory_symlink(outside.path(), folder.path("outside"));
  folder.write("linked.yaml", mapYaml("image: out.img"));
  for (const std::string name : {"out.yaml", "in.yaml", "linked.yaml", "outside/map.yaml"}) {
    EXPECT_EQ(loadMap(folder.path(name)).grid.values.size(), 3u) << name;
  }
  for (const std::string name : {"out.yaml", "linked.yaml", "outside/map.yaml"}) {
    expectPathError("not under map_dir", folder.path(name), only(folder.path()));
  }
  EXPECT_EQ(loadMap(folder.path("in.yaml"), only(folder.path())).grid.values.size(), 3u);
}

TEST(MapFile, F13_StrangePaths) {
  const MapFolder folder;
  fs::create_symlink("loop", folder.path("loop"));
  expectPathError("symbolic links", folder.path("loop"));
  expectPathError("", folder.path("loop"), only(folder.path()));
  expectPathError("too long", "/" + std::string(5000, 'x'));
  expectPathError("File name too long", "/" + std::string(1000, 'x'));
  expectPathError("control character", std::string("/tmp/a\0b", 8));
  expectPathError("control character", folder.path("map.yaml\n"));
  for (const std::string image :
       {"\"~\"", "~root/x", "$HOME", "\"${HOME}\"", "\";id;\"", "\"`id`\"", "\"|id\""}) {
    expectImagePathError("No such file", image);
  }
  expectImagePathError("\\x00", "\"a\\0b\"");
  expectImagePathError("control character", "\"a\\nb\"");
}

TEST(MapFile, F14_NamesThatAreNoUtf8) {
  const test::TemporaryFolder folder;
  folder.write("\xE9\xFF.img", smallPgm());
  folder.write("\xE8.yaml", mapYaml("image: \"\xE9\xFF.img\""));
  EXPECT_EQ(loadMap(folder.path("\xE8.yaml")).grid.values.size(), 3u);
  expectPathError("/\\xc0\\x80.yaml: No such", folder.path("\xC0\x80.yaml"));
}

TEST(MapFile, F14_PrintableKeepsUtf8Only) {
  EXPECT_EQ(printable("caf\xC3\xA9 \xE6\xAD\xA3 \xF0\x9F\x97\xBA"),
            "caf\xC3\xA9 \xE6\xAD\xA3 \xF0\x9F\x97\xBA");
  EXPECT_EQ(printable("\x1B[2J\x7F\n"), "\\x1b[2J\\x7f\\x0a");
  EXPECT_EQ(printable("\xC2\x9B"), "\\xc2\\x9b");           // a control character
  EXPECT_EQ(printable("\xC0\xAF"), "\\xc0\\xaf");           // overlong
  EXPECT_EQ(printable("\xE0\x80\xAF"), "\\xe0\\x80\\xaf");  // overlong
  EXPECT_EQ(printable("\xF0\x80\x80\xAF"), "\\xf0\\x80\\x80\\xaf");
  EXPECT_EQ(printable("\xED\xA0\x80"), "\\xed\\xa0\\x80");  // half a surrogate pair
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
  EXPECT_EQ(printable("\xE6\xAD"), "\\xe6\\xad");  // cut short
  EXPECT_EQ(printable("\xF5"), "\\xf5");
}

TEST(MapFile, F26_FileCutShortWhileRead) {
  const test::TemporaryFolder folder;
  FileReader reader(folder.write("f", std::string(100000, 'x')));
  EXPECT_EQ(reader.take(), std::uint8_t{'x'});
  fs::resize_file(folder.path("f"), 70000);
  test::Bytes bytes(99999);
  EXPECT_EQ(reader.read(bytes.data(), bytes.size()), 69999u);
  EXPECT_FALSE(reader.take());
}

TEST(MapFile, F26_ReadErrorsAreReported) {
  const std::string memory = "/proc/self/mem";  // a regular file whose first page cannot be read
  if (!fs::exists(memory)) GTEST_SKIP() << "no " << memory;
  expectFileError(FileErrorCode::kIo, "cannot be read", [&] { FileReader(memory).take(); });
}

}  // namespace
}  // namespace agrid
