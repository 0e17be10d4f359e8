// What the library throws. A numerical outcome never throws: it is a status in a result.
#pragma once
#include <stdexcept>
#include <string>
#include <vector>

#include "knotfit/remedy.h"
namespace [[gnu::visibility("default")]] knotfit {

/// The caller's mistake: an argument, an option or data that no method can use.
/// The message says what is wrong, where (index, line) and what to do: the remedies that it names.
class InvalidInput : public std::invalid_argument {
 public:
  using std::invalid_argument::invalid_argument;
  std::vector<NamedRemedy> remedies() const { return remedies_in(what()); }
};

/// A file that cannot be read as what it claims to be, or an output that cannot be opened.
/// The message begins with "path: " or "path:line: ".
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& path, const std::string& message)
      : std::runtime_error(path + ": " + message), path_(path) {}
  FileError(const std::string& path, long long line, const std::string& message)
      : std::runtime_error(path + ":" + std::to_string(line) + ": " + message), path_(path) {}
  const std::string& path() const noexcept { return path_; }
  std::vector<NamedRemedy> remedies() const { return remedies_in(what()); }

 private:
  std::string path_;
};

/// Writing began and failed (a full disk, an I/O error). No half-written file is left.
class WriteError : public std::runtime_error {
 public:
  WriteError(const std::string& path, const std::string& message)
      : std::runtime_error(path + ": " + message) {}
};

}  // namespace knotfit
