// What is fuzzed: every reader of a file, OpenCASCADE's apart.
#pragma once
#include <span>
#include <string>
#include <string_view>
namespace knotfit::fuzz {

struct Target {
  std::string_view name;  ///< of the program and of the corpus: "ply"
  /// Reads bytes as a file of the format, and holds what was read to its promises (sizes that agree, finite numbers).
  /// \return whether they were read, not refused
  /// \throws std::logic_error  a promise is broken; other exceptions than the reader's own go through
  bool (*read)(std::string_view bytes);
};

std::span<const Target> targets();
/// \return null where there is none of that name
const Target* find_target(std::string_view name);

/// The most memory that reading a file may take at once: ten times the file and 64 MB.
inline std::size_t memory_bound(std::size_t file) {
  return 10 * file + 64'000'000;
}

}  // namespace knotfit::fuzz
