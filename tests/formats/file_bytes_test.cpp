#include "formats/file_bytes.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "formats/support.h"
namespace knotfit::test {
namespace {

TEST(FileBytes, AreThoseOfTheFile) {
  const TemporaryFolder folder;
  std::string bytes;
  for (int k = 0; k < 20000; ++k)
    bytes += static_cast<char>(k * k);  // beyond the first guess, zeros included
  std::ofstream(folder.file("a.bin"), std::ios::binary) << bytes;
  const FileBytes file = load_file(folder.file("a.bin"));
  EXPECT_EQ(file.view(), bytes);
  EXPECT_EQ(file.size(), bytes.size());
  EXPECT_EQ(file.path(), folder.file("a.bin"));
  EXPECT_EQ(FileBytes("b.bin", bytes).view(), bytes) << "a copy of what is in memory";
}

TEST(FileBytes, SaysWhyThereAreNone) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("empty"));
  const auto bad = [](const std::string& path, const std::string& words) {
    expect_throw<FileError>([&] { load_file(path); }, words);
  };
  bad("", "no file name given");
  bad(folder.file("gone"), "gone: no such file");
  bad(folder.file("empty") + "/x", "no such file");
  bad(folder.path().string(), "is a folder, not a file");
  bad(folder.file("empty"), "the file is empty");
  bad("/dev/zero", "is neither a file nor a pipe");
}

}  // namespace
}  // namespace knotfit::test
