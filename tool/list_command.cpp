#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "commands.h"
#include "exit_status.h"
#include "knotfit/io.h"
#include "knotfit/place.h"
#include "outputs.h"
namespace knotfit::tool {

using Json = nlohmann::ordered_json;

int run_methods(const Arguments& arguments) {
  std::string text;
  Json list = Json::array();
  std::size_t width = 0;
  for (const PlacementMethod& m : placement_methods()) width = std::max(width, m.name.size());
  for (const PlacementMethod& m : placement_methods()) {
    list.push_back({{"name", m.name},
                    {"summary", m.summary},
                    {"source", m.source},
                    {"moves_knots", m.traits.moves_knots},
                    {"needs_rows", m.traits.needs_rows}});
    text += arguments.names ? fmt::format("{}\n", m.name)
                            : fmt::format("{:<{}}  {}{} [{}]\n", m.name, width, m.summary,
                                          m.traits.needs_rows ? " (rows)" : "", m.source);
  }
  print(arguments.json ? list.dump() + "\n" : text);
  return kReached;
}

int run_formats(const Arguments& arguments) {
  std::string text;
  Json list = Json::array();
  for (const FormatInfo& f : all_formats()) {
    list.push_back({{"name", f.name},
                    {"extensions", f.extensions},
                    {"summary", f.summary},
                    {"reads", f.reads},
                    {"writes", f.writes}});
    text += arguments.names ? fmt::format("{}\n", f.name)
                            : fmt::format("{:<13} {:<5} {:<6} {:<25} {}\n", f.name, f.reads ? "reads" : "",
                                          f.writes ? "writes" : "", f.extensions, f.summary);
  }
  print(arguments.json ? list.dump() + "\n" : text);
  return kReached;
}

}  // namespace knotfit::tool
