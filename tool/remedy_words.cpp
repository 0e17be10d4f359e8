#include "remedy_words.h"
namespace knotfit::tool {
namespace {

// No default: the compiler names a remedy without words.
std::string_view words_for(Remedy remedy) {
  switch (remedy) {
    case Remedy::format:
      return "--input-format";
    case Remedy::columns:
      return "--columns";
    case Remedy::nodata:
      return "--nodata";
    case Remedy::skip_lines:
      return "--skip-lines";
    case Remedy::block:
      return "--block";
    case Remedy::classes:
      return "--classes";
    case Remedy::returns:
      return "--returns";
    case Remedy::height_field:
      return "--height-field";
    case Remedy::rescale:
      return "--rescale-parameters";
    case Remedy::duplicates:
      return "--duplicates";
    case Remedy::base:
      return "--base";
    case Remedy::fill_holes:
      return "--fill-holes";
    case Remedy::largest_part:
      return "--largest-part";
    case Remedy::orient:
      return "--orient";
    case Remedy::drop_degenerate:
      return "--drop-degenerate";
    case Remedy::vertices:
      return "knotfit convert MESH -o points.csv";
    case Remedy::degree:
      return "--degree";
    case Remedy::smoothing:
      return "--smoothing";
    case Remedy::correct:
      return "--correct";
    case Remedy::corrections:
      return "--corrected";
    case Remedy::closed:
      return "--closed";
    case Remedy::force:
      return "--force";
  }
  return "";
}

}  // namespace

std::string words_for(const NamedRemedy& remedy) {
  std::string words(words_for(remedy.remedy));
  if (!remedy.value.empty()) words += " " + remedy.value;
  return words;
}

std::string in_tool_words(std::string_view text) {
  return say_remedies(text, [](const NamedRemedy& remedy) { return words_for(remedy); });
}

}  // namespace knotfit::tool
