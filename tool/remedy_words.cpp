#include "remedy_words.h"

#include <array>
namespace knotfit::tool {
namespace {

struct Words {
  Remedy remedy;
  std::string_view words;
};
constexpr auto kWords = std::to_array<Words>({{Remedy::format, "--input-format"},
                                              {Remedy::columns, "--columns"},
                                              {Remedy::nodata, "--nodata"},
                                              {Remedy::skip_lines, "--skip-lines"},
                                              {Remedy::block, "--block"},
                                              {Remedy::classes, "--classes"},
                                              {Remedy::returns, "--returns"},
                                              {Remedy::height_field, "--height-field"},
                                              {Remedy::rescale, "--rescale-parameters"},
                                              {Remedy::duplicates, "--duplicates"},
                                              {Remedy::base, "--base"},
                                              {Remedy::fill_holes, "--fill-holes"},
                                              {Remedy::largest_part, "--largest-part"},
                                              {Remedy::orient, "--orient"},
                                              {Remedy::drop_degenerate, "--drop-degenerate"},
                                              {Remedy::vertices, "knotfit convert MESH -o points.csv"},
                                              {Remedy::degree, "--degree"},
                                              {Remedy::smoothing, "--smoothing"},
                                              {Remedy::correct, "--correct"},
                                              {Remedy::corrections, "--corrected"},
                                              {Remedy::closed, "--closed"},
                                              {Remedy::force, "--force"}});

// A remedy without words, or out of order, does not compile.
static_assert([] {
  for (std::size_t k = 0; k < kWords.size(); ++k)
    if (kWords[k].remedy != static_cast<Remedy>(k)) return false;
  return kWords.back().remedy == kLastRemedy;
}());

}  // namespace

std::string words_for(const NamedRemedy& remedy) {
  std::string words(kWords[static_cast<std::size_t>(remedy.remedy)].words);
  if (!remedy.value.empty()) words += " " + remedy.value;
  return words;
}

std::string in_tool_words(std::string_view text) {
  return say_remedies(text, [](const NamedRemedy& remedy) { return words_for(remedy); });
}

}  // namespace knotfit::tool
