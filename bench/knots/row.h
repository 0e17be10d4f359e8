// One measured figure of docs/knots.md: a name in words and what it takes to measure it.
#pragma once
#include <functional>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>
namespace knotfit::bench {

using Figures = nlohmann::ordered_json;

struct Row {
  std::vector<std::string> words;  ///< the table's name first: "tolerance", "ridge", "best", "1"
  std::function<Figures()> measure;
};

// A table of docs/knots.md each, in the order of the page.
std::vector<Row> equal_knots_rows();
std::vector<Row> tolerance_rows();
std::vector<Row> hostile_rows();
std::vector<Row> time_rows();
std::vector<Row> rms_rows();
std::vector<Row> sweep_rows();
std::vector<Row> known_knots_rows();
std::vector<Row> insertion_rows();
std::vector<Row> shear_rows();
std::vector<Row> guard_cost_rows();

}  // namespace knotfit::bench
