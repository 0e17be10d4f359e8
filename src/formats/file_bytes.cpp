#include "formats/file_bytes.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

std::string reason(int error) {
  return std::generic_category().message(error);
}

struct Descriptor {
  int fd = -1;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
};

}  // namespace

FileBytes::FileBytes(std::string path, std::string_view content)
    : path_(std::move(path)),
      data_(std::make_unique_for_overwrite<char[]>(content.size() + 1)),
      size_(content.size()) {
  if (size_ > 0) std::memcpy(data_.get(), content.data(), size_);
}

FileBytes load_file(const std::string& path) {
  if (path.empty()) throw FileError(path, "no file name given");
  struct stat info {};
  if (::stat(path.c_str(), &info) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) throw FileError(path, "no such file");
    throw FileError(path, "cannot be read: " + reason(errno));
  }
  if (S_ISDIR(info.st_mode)) throw FileError(path, "is a folder, not a file");
  // A device such as /dev/zero has no end.
  if (!S_ISREG(info.st_mode) && !S_ISFIFO(info.st_mode))
    throw FileError(path, "is neither a file nor a pipe");

  Descriptor file{::open(path.c_str(), O_RDONLY | O_CLOEXEC)};
  if (file.fd < 0) throw FileError(path, "cannot be read: " + reason(errno));
  // The size is a first guess only: a pipe has none and a file may grow while it is read.
  std::size_t capacity = std::max<std::size_t>(static_cast<std::size_t>(info.st_size) + 1, 4096), size = 0;
  auto data = std::make_unique_for_overwrite<char[]>(capacity);
  for (;;) {
    if (size == capacity) {
      auto larger = std::make_unique_for_overwrite<char[]>(2 * capacity);
      std::memcpy(larger.get(), data.get(), size);
      data = std::move(larger);
      capacity *= 2;
    }
    const ssize_t count = ::read(file.fd, data.get() + size, capacity - size);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw FileError(path, "cannot be read: " + reason(errno));
    if (count == 0) break;
    size += static_cast<std::size_t>(count);
  }
  if (size == 0) throw FileError(path, "the file is empty");
  return FileBytes(path, std::move(data), size);
}

}  // namespace knotfit
