// A whole file in memory.
#pragma once
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
namespace knotfit {

/// The bytes of a file and the path they came from, for messages.
class FileBytes {
 public:
  FileBytes() = default;
  FileBytes(std::string path, std::string_view content);
  FileBytes(std::string path, std::unique_ptr<char[]> data, std::size_t size)
      : path_(std::move(path)), data_(std::move(data)), size_(size) {}
  const std::string& path() const { return path_; }
  std::size_t size() const { return size_; }
  std::string_view view() const { return {data_.get(), size_}; }

 private:
  std::string path_;
  std::unique_ptr<char[]> data_;
  std::size_t size_ = 0;
};

/// Reads a file or a pipe to its end.
/// \throws FileError  missing, a folder, a device, unreadable, or empty
FileBytes load_file(const std::string& path);

}  // namespace knotfit
