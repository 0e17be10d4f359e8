// What can be said of a CAD file before OpenCASCADE sees it: its kind, whether it is whole, its unit.
#include "formats/cad/iges_sections.h"
#include "formats/cad/occt.h"
#include "formats/cad/step_syntax.h"
#include "formats/foreign.h"
#include "knotfit/exceptions.h"
namespace knotfit::cad {
namespace {

/// Without blanks, and without what DOS files are padded with.
std::string_view trimmed_end(std::string_view text) {
  while (!text.empty() && std::string_view(" \t\r\n\0\x1A", 6).find(text.back()) != std::string_view::npos)
    text.remove_suffix(1);
  return text;
}

CadUnit iges_unit(std::string_view bytes, const std::string& path) {
  const std::vector<std::string> parameters = iges_global_parameters(bytes);
  std::string flag = parameters.size() > 13 ? parameters[13] : "";
  std::erase(flag, ' ');
  if (flag == "2") return CadUnit::millimetre;
  if (flag == "6") return CadUnit::metre;
  if (flag == "1" || flag.empty()) return CadUnit::inch;  // the default
  throw FileError(path, "is in a unit of flag " + flag + ", neither mm, m nor inch");
}

CadUnit step_unit(std::string_view bytes, const std::string& path) {
  std::string text;  // without blanks, which may stand anywhere
  for (const char c : bytes)
    if (c != ' ' && c != '\n' && c != '\r' && c != '\t') text += c;
  const auto has = [&](std::string_view word) { return text.find(word) != std::string::npos; };
  if (has("CONVERSION_BASED_UNIT('INCH'")) return CadUnit::inch;
  if (has("SI_UNIT(.MILLI.,.METRE.)")) return CadUnit::millimetre;
  if (has("SI_UNIT($,.METRE.)")) return CadUnit::metre;
  throw FileError(path, "names no unit of length of mm, m and inch");
}

}  // namespace

FileKind kind_of(std::string_view bytes, const std::string& path) {
  const std::string_view whole = trimmed_end(bytes);
  if (looks_like_step(bytes)) {
    check_step(whole, path);
    return FileKind::step;
  }
  if (looks_like_iges(bytes)) {
    check_iges(whole, path);
    return FileKind::iges;
  }
  if (const std::string why = foreign_file(bytes, path); !why.empty()) throw FileError(path, why);
  throw FileError(path, "is neither STEP (ISO-10303-21) nor IGES (80 columns)");
}

CadUnit unit_of(std::string_view bytes, FileKind kind, const std::string& path) {
  return kind == FileKind::step ? step_unit(bytes, path) : iges_unit(bytes, path);
}

}  // namespace knotfit::cad
