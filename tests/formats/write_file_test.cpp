#include <sys/mount.h>
#include <sys/stat.h>

#include "support.h"
namespace knotfit::test {
namespace {

void put(const std::string& path, bool force, const std::string& text) {
  write_file(path, force, [&](std::ostream& out) { out << text; });
}

TEST(WriteFile, WritesWholeFilesAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string big(1'000'000, 'x');
  put(folder.file("a.txt"), false, big);
  EXPECT_EQ(bytes_of(folder.file("a.txt")), big);
  EXPECT_EQ(folder.count(), 1U);
  put(folder.file(std::string(255, 'n')), false, "long name");  // as long as the file system allows
  EXPECT_EQ(folder.count(), 2U);
  put(folder.file("empty"), false, "");
  EXPECT_TRUE(std::filesystem::exists(folder.file("empty")));
}

TEST(WriteFile, ReplacesOnlyWithForce) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  put(path, false, "old");
  ::chmod(path.c_str(), 0640);
  expect_throw<FileError>([&] { put(path, false, "new"); }, "exists already; `force` replaces it");
  EXPECT_EQ(bytes_of(path), "old");
  put(path, true, "new");
  EXPECT_EQ(bytes_of(path), "new");
  struct stat info {};
  ASSERT_EQ(::stat(path.c_str(), &info), 0);
  EXPECT_EQ(info.st_mode & 0777, 0640U);  // the permissions of the file replaced
  EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFile, AFileThatCameUpInTheMeantimeStays) {
  const TemporaryFolder folder;
  const std::string path = folder.file("a.txt");
  expect_throw<FileError>(
      [&] {
        write_file(path, false, [&](std::ostream& out) {
          std::ofstream(path) << "other";
          out << "mine";
        });
      },
      "exists already");
  EXPECT_EQ(bytes_of(path), "other");
  EXPECT_EQ(folder.count(), 1U);
}

TEST(WriteFile, LinksKeepPointingToTheirFile) {
  const TemporaryFolder folder;
  put(folder.file("real.txt"), false, "old");
  std::filesystem::create_symlink("real.txt", folder.file("link.txt"));
  expect_throw<FileError>([&] { put(folder.file("link.txt"), false, "new"); }, "exists already");
  put(folder.file("link.txt"), true, "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.file("link.txt")));
  EXPECT_EQ(bytes_of(folder.file("real.txt")), "new");
  std::filesystem::create_symlink("later.txt", folder.file("dangling.txt"));
  put(folder.file("dangling.txt"), false, "new");
  EXPECT_EQ(bytes_of(folder.file("later.txt")), "new");
  std::filesystem::create_symlink("loop.txt", folder.file("loop.txt"));
  expect_throw<FileError>([&] { put(folder.file("loop.txt"), true, "new"); }, "cannot be written");
}

TEST(WriteFile, NamesWhatIsWrongWithTheTarget) {
  const TemporaryFolder folder;
  const auto both = [&](const std::string& path, const std::string& words) {
    SCOPED_TRACE(path);
    expect_throw<FileError>([&] { check_writable(path, true); }, words);
    expect_throw<FileError>([&] { put(path, true, "x"); }, words);
  };
  both(folder.file("none/a.txt"), "does not exist");
  put(folder.file("file"), false, "x");
  both(folder.file("file/a.txt"), "does not exist");
  both(folder.path().string(), "is a folder; name a file in it");
  both(folder.path().string() + "/", "is a folder; name a file in it");
  both("", "no name given for the output");
  both(folder.file(std::string(300, 'n')), "cannot be written");
  expect_throw<FileError>([&] { check_writable(folder.file("file"), false); }, "exists already; `force`");
  EXPECT_NO_THROW(check_writable(folder.file("file"), true));
  EXPECT_NO_THROW(check_writable(folder.file("new"), false));
  EXPECT_FALSE(std::filesystem::exists(folder.file("new")));
  // Nobody may create files here, root neither.
  expect_throw<FileError>([&] { put("/proc/knotfit-test.json", false, "x"); }, "cannot be written");
  if (::geteuid() != 0) {
    std::filesystem::permissions(folder.path(),
                                 std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
    both(folder.file("new"), "cannot be written to");
    std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
  }
}

TEST(WriteFile, AFailedStreamLeavesNothing) {
  const TemporaryFolder folder;
  put(folder.file("a.txt"), false, "old");
  expect_throw<WriteError>(
      [&] {
        write_file(folder.file("a.txt"), true, [](std::ostream& out) {
          out << "half";
          out.setstate(std::ios::badbit);
        });
      },
      "writing failed");
  EXPECT_THROW(write_file(folder.file("b.txt"), false,
                          [](std::ostream& out) {
                            out << "half";
                            throw InvalidInput("no");
                          }),
               InvalidInput);
  EXPECT_EQ(bytes_of(folder.file("a.txt")), "old");
  EXPECT_EQ(folder.count(), 1U);
}

// /dev/full fails every write as a full disk does; a device is written to, never replaced.
TEST(WriteFile, AFullDeviceIsAWriteError) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "there is no /dev/full";
  expect_throw<WriteError>([&] { put("/dev/full", false, "x"); },
                           "/dev/full: writing failed: No space left on device");
  expect_throw<WriteError>([&] { put("/dev/full", true, std::string(1'000'000, 'x')); },
                           "No space left on device");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/full"));
  EXPECT_NO_THROW(put("/dev/null", false, "x"));
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST(WriteFile, AFullDiskLeavesTheOldFileAndNothingElse) {
  const TemporaryFolder folder;
  if (::mount("tmpfs", folder.path().c_str(), "tmpfs", 0, "size=64k") != 0)
    GTEST_SKIP() << "a small file system cannot be mounted here";
  struct Unmount {
    std::string path;
    ~Unmount() { ::umount(path.c_str()); }
  } unmount{folder.path().string()};
  put(folder.file("a.txt"), false, "old");
  expect_throw<WriteError>([&] { put(folder.file("a.txt"), true, std::string(200'000, 'x')); },
                           "writing failed: No space left on device");
  expect_throw<WriteError>([&] { put(folder.file("b.txt"), false, std::string(200'000, 'x')); },
                           "No space left");
  EXPECT_EQ(bytes_of(folder.file("a.txt")), "old");
  EXPECT_EQ(folder.count(), 1U);
}

}  // namespace
}  // namespace knotfit::test
