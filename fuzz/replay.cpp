// Every file of a corpus through its reader, without libFuzzer: replay TARGET FILE|FOLDER... The bounds on memory and
// time are the fuzzer's. At least one file must be read, so that the corpus reaches what lies behind the refusals.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "formats/allocation_watch.h"
#include "targets.h"
namespace {

namespace fs = std::filesystem;
using namespace knotfit::fuzz;

constexpr double kSeconds = 10;  // a file; the corpus is of files far below a megabyte

std::vector<fs::path> files_of(int count, char** paths) {
  std::vector<fs::path> files;
  for (int k = 0; k < count; ++k) {
    if (!fs::is_directory(paths[k])) {
      files.emplace_back(paths[k]);
      continue;
    }
    for (const auto& entry : fs::recursive_directory_iterator(paths[k]))
      if (entry.is_regular_file()) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

// \return what is wrong; empty: nothing
std::string replay(const Target& target, const std::string& bytes, bool& read) {
  const auto start = std::chrono::steady_clock::now();
  std::size_t peak = 0;
  try {
    const knotfit::test::PeakMemory memory;
    read = target.read(bytes);
    peak = memory.bytes();
  } catch (const std::exception& e) {
    return e.what();
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (peak > memory_bound(bytes.size())) return std::to_string(peak) + " bytes in use at once";
  if (seconds > kSeconds) return std::to_string(seconds) + " s";
  return "";
}

}  // namespace

int main(int argc, char** argv) {
  const Target* target = argc > 2 ? find_target(argv[1]) : nullptr;
  if (target == nullptr) {
    std::string names;
    for (const Target& t : targets()) names += " " + std::string(t.name);
    std::fprintf(stderr, "replay TARGET FILE|FOLDER...; targets:%s\n", names.c_str());
    return 2;
  }
  int wrong = 0, readable = 0;
  const std::vector<fs::path> files = files_of(argc - 2, argv + 2);
  for (const fs::path& path : files) {
    std::ifstream in(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
    bool read = false;
    const std::string what = replay(*target, bytes, read);
    readable += read;
    if (what.empty()) continue;
    ++wrong;
    std::printf("%s (%zu bytes): %s\n", path.c_str(), bytes.size(), what.c_str());
  }
  std::printf("%s: %zu files, %d of them read, %d wrong\n", argv[1], files.size(), readable, wrong);
  return wrong == 0 && readable > 0 ? 0 : 1;
}
