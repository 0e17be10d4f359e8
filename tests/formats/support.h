// Files of every format written by the tests themselves.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "formats/readers.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "support/expect_throw.h"
#include "support/random_splines.h"
namespace knotfit::test {

inline constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
inline constexpr double kInf = std::numeric_limits<double>::infinity();

/// Reads bytes as if they were the file of that name.
inline SourceData read(const std::string& name, std::string_view bytes, const ReadOptions& options = {}) {
  return read_bytes(FileBytes(name, bytes), options);
}

template <class Content>
Content content(const SourceData& data) {
  EXPECT_TRUE(std::holds_alternative<Content>(data.content)) << data.path << " read as " << data.format;
  return std::holds_alternative<Content>(data.content) ? std::get<Content>(data.content) : Content{};
}

inline PointTable table(std::string_view text, const ReadOptions& options = {},
                        const std::string& name = "points.csv") {
  return content<PointTable>(read(name, text, options));
}

/// Reading must fail with a FileError that has these words.
inline void refuses(const std::string& name, std::string_view bytes, const std::string& words,
                    const ReadOptions& options = {}) {
  SCOPED_TRACE(name + ": " + std::string(bytes.substr(0, 60)));
  expect_throw<FileError>([&] { read(name, bytes, options); }, words);
}

inline std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

inline std::filesystem::path test_data(const std::string& name) {
  return std::filesystem::path(KNOTFIT_TEST_DATA) / name;
}
inline std::filesystem::path sample(const std::string& name) {
  return std::filesystem::path(KNOTFIT_TEST_DATA) / ".." / ".." / "samples" / name;
}

/// A folder that vanishes with the test.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "knotfit-test-XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  std::string file(const std::string& name) const { return (path_ / name).string(); }
  const std::filesystem::path& path() const { return path_; }
  /// Files there, whatever their names.
  std::size_t count() const {
    std::size_t n = 0;
    for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(path_)) ++n;
    return n;
  }

 private:
  std::filesystem::path path_;
};

/// An NPY file: magic, version, header with this dictionary, and the data.
inline std::string npy(const std::string& dictionary, const std::string& data, int version = 1) {
  const std::size_t prefix = version == 1 ? 10 : 12;
  std::string header = dictionary;
  header.append(63 - (prefix + header.size()) % 64, ' ');
  header += '\n';
  std::string out = "\x93NUMPY";
  out += static_cast<char>(version);
  out += '\0';
  for (std::size_t k = 0; k < prefix - 8; ++k) out += static_cast<char>(header.size() >> 8 * k & 255);
  return out + header + data;
}

inline std::string npy_dictionary(const std::string& type, const std::string& shape, bool fortran = false) {
  return "{'descr': '" + type + "', 'fortran_order': " + (fortran ? "True" : "False") + ", 'shape': (" +
         shape + "), }";
}

/// Values as items of type T in the byte order asked for.
template <class T>
std::string items(const std::vector<double>& values, bool big_endian = false) {
  std::string out;
  for (const double value : values) {
    const T item = static_cast<T>(value);
    char bytes[sizeof(T)];
    std::memcpy(bytes, &item, sizeof(T));
    std::string text(bytes, sizeof(T));
    if (big_endian != (std::endian::native == std::endian::big)) text.assign(text.rbegin(), text.rend());
    out += text;
  }
  return out;
}

inline std::string doubles(const std::string& shape, const std::vector<double>& values) {
  return npy(npy_dictionary("<f8", shape), items<double>(values));
}

/// The bytes after 1 to `changes` changes: one becomes any byte, or one of the alphabet; up to `run` of them go, or are
/// put in again further on.
inline std::string damaged(std::string bytes, Random& random, std::string_view alphabet, int changes,
                           int run) {
  for (int change = random.integer(1, changes); change > 0 && !bytes.empty(); --change) {
    const auto at = static_cast<std::size_t>(random.integer(0, static_cast<int>(bytes.size()) - 1));
    switch (random.integer(0, 3)) {
      case 0:
        bytes[at] = static_cast<char>(random.integer(0, 255));
        break;
      case 1:
        bytes[at] =
            alphabet[static_cast<std::size_t>(random.integer(0, static_cast<int>(alphabet.size()) - 1))];
        break;
      case 2:
        bytes.erase(at, static_cast<std::size_t>(random.integer(1, run)));
        break;
      default:
        bytes.insert(at, bytes.substr(at / 2, static_cast<std::size_t>(random.integer(1, run))));
    }
  }
  return bytes;
}

/// Equal, NaN equal to NaN.
inline void expect_same(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_TRUE(a[k] == b[k] || (std::isnan(a[k]) && std::isnan(b[k]))) << k << ": " << a[k] << " " << b[k];
}

}  // namespace knotfit::test
