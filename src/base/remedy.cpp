#include "knotfit/remedy.h"

#include <algorithm>
#include <array>
#include <optional>
namespace knotfit {
namespace {

struct Row {
  Remedy remedy;
  std::string_view name;
};
constexpr auto kRows = std::to_array<Row>({{Remedy::format, "format"},
                                           {Remedy::columns, "columns"},
                                           {Remedy::nodata, "nodata"},
                                           {Remedy::skip_lines, "skip_lines"},
                                           {Remedy::block, "block"},
                                           {Remedy::classes, "classes"},
                                           {Remedy::returns, "returns"},
                                           {Remedy::height_field, "height_field"},
                                           {Remedy::rescale, "rescale"},
                                           {Remedy::duplicates, "duplicates"},
                                           {Remedy::base, "base"},
                                           {Remedy::fill_holes, "fill_holes"},
                                           {Remedy::largest_part, "largest_part"},
                                           {Remedy::orient, "orient"},
                                           {Remedy::drop_degenerate, "drop_degenerate"},
                                           {Remedy::vertices, "vertices"},
                                           {Remedy::degree, "degree"},
                                           {Remedy::smoothing, "smoothing"},
                                           {Remedy::correct, "correct"},
                                           {Remedy::corrections, "corrections"},
                                           {Remedy::closed, "closed"},
                                           {Remedy::force, "force"}});

// Each value has its row, at its own place.
static_assert([] {
  for (std::size_t k = 0; k < kRows.size(); ++k)
    if (kRows[k].remedy != static_cast<Remedy>(k)) return false;
  return kRows.back().remedy == kLastRemedy;
}());

constexpr std::string_view kIs = " = ";

constexpr auto kAll = [] {
  std::array<Remedy, kRows.size()> all{};
  for (std::size_t k = 0; k < all.size(); ++k) all[k] = kRows[k].remedy;
  return all;
}();

/// Of what stands between two backquotes.
std::optional<NamedRemedy> remedy_of(std::string_view quoted) {
  const std::size_t end = quoted.find(kIs);
  const auto found = std::find_if(kRows.begin(), kRows.end(), [name = quoted.substr(0, end)](const Row& row) {
    return row.name == name;
  });
  if (found == kRows.end()) return std::nullopt;
  const std::string_view value = end == std::string_view::npos ? "" : quoted.substr(end + kIs.size());
  return NamedRemedy{found->remedy, std::string(value)};
}

}  // namespace

std::span<const Remedy> all_remedies() {
  return kAll;
}

std::string_view remedy_name(Remedy remedy) {
  return kRows[static_cast<std::size_t>(remedy)].name;
}

std::string remedy_text(Remedy remedy, std::string_view value) {
  std::string text = "`" + std::string(remedy_name(remedy));
  if (!value.empty()) text.append(kIs).append(value);
  return text + "`";
}

std::string say_remedies(std::string_view text, const std::function<std::string(const NamedRemedy&)>& say) {
  std::string said;
  while (true) {
    const std::size_t begin = text.find('`');
    const std::size_t end = begin == std::string_view::npos ? begin : text.find('`', begin + 1);
    if (end == std::string_view::npos) return said.append(text);
    const auto remedy = remedy_of(text.substr(begin + 1, end - begin - 1));
    said.append(text.substr(0, begin));
    if (remedy)
      said += say(*remedy);
    else
      said.append(text.substr(begin, end - begin));  // the second backquote may begin a remedy
    text.remove_prefix(remedy ? end + 1 : end);
  }
}

std::vector<NamedRemedy> remedies_in(std::string_view text) {
  std::vector<NamedRemedy> remedies;
  say_remedies(text, [&](const NamedRemedy& remedy) {
    remedies.push_back(remedy);
    return std::string();
  });
  return remedies;
}

}  // namespace knotfit
