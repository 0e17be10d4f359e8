#include "reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
namespace knotfit::tool {
namespace {

bool is_used(const std::string& column) {
  constexpr std::array<const char*, 9> kUsed = {"x", "y", "z", "u", "v", "w", "nx", "ny", "nz"};
  return std::find(kUsed.begin(), kUsed.end(), column) != kUsed.end();
}

}  // namespace

Reading reading_of(const SourceData& data) {
  return {data.columns, data.columns_from, data.left_out, data.notes};
}

std::string columns_to_text(const Reading& reading) {
  if (reading.columns.empty()) return "";
  std::string left_out;
  for (const std::string& column : reading.columns)
    if (!is_used(column)) left_out += (left_out.empty() ? "" : " ") + column;
  const char* from = reading.from == "option"   ? "as --columns says"
                     : reading.from == "header" ? "by the header"
                                                : "guessed";
  return fmt::format("columns: {} ({}{}{})\n", fmt::join(reading.columns, " "), from,
                     left_out.empty() ? "" : "; left out: ", left_out);
}

std::string notes_to_text(const Reading& reading) {
  std::string text;
  for (const std::string& note : reading.notes) text += "note: " + note + "\n";
  return text;
}

}  // namespace knotfit::tool
