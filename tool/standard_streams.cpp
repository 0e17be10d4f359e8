#include "standard_streams.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "knotfit/exceptions.h"
namespace knotfit::tool {
namespace {

constexpr const char* kInput = "standard input";

std::string everything() {
  std::string bytes;
  char block[65536];
  for (;;) {
    const std::size_t count = std::fread(block, 1, sizeof block, stdin);
    bytes.append(block, count);
    if (count == sizeof block) continue;
    if (std::ferror(stdin) != 0)
      throw FileError(kInput, std::string("cannot be read: ") + std::strerror(errno));
    return bytes;
  }
}

}  // namespace

bool is_dash(const std::string& path) {
  return path == "-";
}

FileBytes standard_input() {
  static const std::string bytes = everything();
  if (bytes.empty()) throw FileError(kInput, "is empty");
  return FileBytes(kInput, bytes);
}

std::string input_name(const std::string& path) {
  return is_dash(path) ? kInput : path;
}

}  // namespace knotfit::tool
