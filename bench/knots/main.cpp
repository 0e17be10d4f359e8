// Measures the figures of docs/knots.md: knotfit_bench_knots [--list] [WORD... | --row NAME]
// A row is measured where its words contain all of those given: "tolerance ridge best" is five rows; or the one of
// exactly that name. One line of JSON a row on standard output.
#include <algorithm>
#include <cstdio>
#include <exception>

#include "row.h"
int main(int argc, char** argv) {
  using namespace knotfit::bench;
  std::vector<std::string> wanted(argv + 1, argv + argc);
  const bool list = std::erase(wanted, "--list") > 0;
  const bool exact = wanted.size() == 2 && wanted.front() == "--row";
  try {
    int rows = 0;
    for (const auto& table : {equal_knots_rows, tolerance_rows, hostile_rows, time_rows, rms_rows, sweep_rows,
                              known_knots_rows, insertion_rows, shear_rows, guard_cost_rows})
      for (const Row& row : table()) {
        const auto contains = [&](const std::string& word) {
          return std::find(row.words.begin(), row.words.end(), word) != row.words.end();
        };
        std::string name;
        for (const std::string& word : row.words) name += (name.empty() ? "" : " ") + word;
        if (exact ? name != wanted.back() : !std::all_of(wanted.begin(), wanted.end(), contains)) continue;
        ++rows;
        if (list) {
          std::printf("%s\n", name.c_str());
          continue;
        }
        Figures line;
        line["row"] = name;
        line.update(row.measure());
        std::printf("%s\n", line.dump().c_str());
        std::fflush(stdout);
      }
    if (rows == 0) {
      std::fprintf(stderr, "no row has all of these words; --list shows the rows there are\n");
      return 2;
    }
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
