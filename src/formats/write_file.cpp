// Files written whole or not at all.
#include "formats/write_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <ostream>
#include <streambuf>
#include <system_error>

#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/remedy.h"
namespace knotfit {
namespace {

namespace fs = std::filesystem;

std::string reason(int error) {
  return std::generic_category().message(error);
}

std::string exists_already() {
  return "exists already; " + remedy_text(Remedy::force) + " replaces it";
}

/// A stream into a descriptor that remembers the first error.
class DescriptorBuffer : public std::streambuf {
 public:
  explicit DescriptorBuffer(int fd) : fd_(fd) { setp(buffer_.data(), buffer_.data() + buffer_.size()); }
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) sputc(traits_type::to_char_type(c));
    return traits_type::not_eof(c);
  }
  int sync() override {
    const char* p = pbase();
    while (error_ == 0 && p < pptr()) {
      const ssize_t count = ::write(fd_, p, static_cast<std::size_t>(pptr() - p));
      if (count >= 0)
        p += count;
      else if (errno != EINTR)
        error_ = errno;
    }
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return error_ == 0 ? 0 : -1;
  }

 private:
  int fd_;
  int error_ = 0;
  std::array<char, 1 << 16> buffer_;
};

/// Where a path leads and what stands there now.
struct Target {
  fs::path file;  ///< links resolved: a link keeps pointing to the file it names
  fs::path folder;
  bool exists = false;
  bool special = false;  ///< a pipe or a device: written to, never replaced
  mode_t mode = 0;
};

Target find_target(const std::string& path, bool force) {
  if (path.empty()) throw FileError(path, "no name given for the output");
  Target target;
  target.file = path;
  std::error_code error;
  for (int links = 0; fs::is_symlink(target.file, error); ++links) {
    if (links == 40) throw FileError(path, "cannot be written: " + reason(ELOOP));
    target.file = target.file.parent_path() / fs::read_symlink(target.file, error);
    if (error) throw FileError(path, "cannot be written: " + error.message());
  }
  target.folder = target.file.parent_path();
  if (target.folder.empty()) target.folder = ".";
  struct stat info {};
  if (::stat(target.folder.c_str(), &info) != 0 || !S_ISDIR(info.st_mode))
    throw FileError(path, "the folder \"" + target.folder.string() + "\" does not exist");
  if (!target.file.has_filename()) throw FileError(path, "is a folder; name a file in it");
  if (::stat(target.file.c_str(), &info) == 0) {
    target.exists = true;
    if (S_ISDIR(info.st_mode)) throw FileError(path, "is a folder; name a file in it");
    target.special = !S_ISREG(info.st_mode);
    target.mode = info.st_mode & 07777;
    if (!target.special && !force) throw FileError(path, exists_already());
  } else if (errno != ENOENT) {
    throw FileError(path, "cannot be written: " + reason(errno));
  }
  if (!target.special && ::access(target.folder.c_str(), W_OK | X_OK) != 0)
    throw FileError(path,
                    "the folder \"" + target.folder.string() + "\" cannot be written to: " + reason(errno));
  if (target.special && ::access(target.file.c_str(), W_OK) != 0)
    throw FileError(path, "cannot be written: " + reason(errno));
  return target;
}

/// An open file that vanishes unless it is kept.
struct OpenFile {
  int fd = -1;
  std::string temporary;  ///< empty: written in place
  ~OpenFile() {
    if (fd >= 0) ::close(fd);
    if (!temporary.empty()) ::unlink(temporary.c_str());
  }
};

void open_beside(OpenFile& file, const std::string& path, const Target& target) {
  static std::atomic<unsigned> counter{0};
  for (int attempt = 0; attempt < 1000; ++attempt) {
    // A name of its own length: the target's may be as long as the file system allows.
    const fs::path name = target.folder / (".knotfit-" + std::to_string(::getpid()) + "-" +
                                           std::to_string(counter.fetch_add(1)) + ".tmp");
    file.fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file.fd >= 0) {
      file.temporary = name.string();
      return;
    }
    if (errno != EEXIST) break;
  }
  const int error = errno;
  if (error == ENOSPC || error == EDQUOT || error == EIO)
    throw WriteError(path, "writing failed: " + reason(error));
  throw FileError(path, "cannot be written: " + reason(error));
}

/// Gives the temporary file its name. Without force a file that came up in the meantime stays.
int rename_to(const std::string& temporary, const std::string& target, bool force) {
#ifdef RENAME_NOREPLACE
  if (!force) {
    if (::renameat2(AT_FDCWD, temporary.c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) == 0) return 0;
    if (errno != EINVAL && errno != ENOSYS) return errno;
  }
#endif
  if (!force) {
    std::error_code error;
    if (fs::exists(target, error)) return EEXIST;
  }
  return ::rename(temporary.c_str(), target.c_str()) == 0 ? 0 : errno;
}

}  // namespace

void check_writable(const std::string& path, bool force) {
  find_target(path, force);
}

void write_file(const std::string& path, bool force, const std::function<void(std::ostream&)>& write) {
  write_checked_file(path, force, write, {});
}

void write_checked_file(const std::string& path, bool force, const std::function<void(std::ostream&)>& write,
                        const std::function<void(const std::string&)>& check) {
  const Target target = find_target(path, force);
  OpenFile file;
  if (target.special) {
    if (check) throw FileError(path, "is no plain file: what is read back before it counts needs one");
    file.fd = ::open(target.file.c_str(), O_WRONLY | O_CLOEXEC);
    if (file.fd < 0) throw FileError(path, "cannot be written: " + reason(errno));
  } else {
    open_beside(file, path, target);
    if (target.exists) ::fchmod(file.fd, target.mode);
  }

  DescriptorBuffer buffer(file.fd);
  std::ostream out(&buffer);
  write(out);
  out.flush();
  if (buffer.error() != 0) throw WriteError(path, "writing failed: " + reason(buffer.error()));
  if (!out) throw WriteError(path, "writing failed");
  // A full disk may show itself only here; what cannot be flushed (a pipe) says EINVAL.
  if (::fsync(file.fd) != 0 && errno != EINVAL && errno != EROFS)
    throw WriteError(path, "writing failed: " + reason(errno));
  const int fd = file.fd;
  file.fd = -1;
  if (::close(fd) != 0 && errno != EINTR) throw WriteError(path, "writing failed: " + reason(errno));
  if (target.special) return;
  if (check) check(file.temporary);

  if (const int error = rename_to(file.temporary, target.file.string(), force); error != 0) {
    if (error == EEXIST) throw FileError(path, exists_already());
    throw WriteError(path, "writing failed: " + reason(error));
  }
  file.temporary.clear();
  // The new name reaches the disk with its folder; the file is whole either way.
  const int folder = ::open(target.folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0) {
    ::fsync(folder);
    ::close(folder);
  }
}

}  // namespace knotfit
