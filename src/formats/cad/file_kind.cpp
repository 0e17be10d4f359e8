// What can be said of a CAD file before OpenCASCADE sees it: its kind, whether it is whole, its unit.
#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "formats/cad/occt.h"
#include "formats/number.h"
#include "knotfit/errors.h"
namespace knotfit::cad {
namespace {

constexpr std::size_t kIgesLine = 80;
constexpr std::string_view kSections = "SGDPT";

std::string_view trimmed_end(std::string_view text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r' || text.back() == ' ' ||
                           text.back() == '\t' || text.back() == '\0'))
    text.remove_suffix(1);
  return text;
}

/// Calls line(text) for each line without its end.
template <class Line>
void for_lines(std::string_view bytes, const Line& line) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    std::string_view text = bytes.substr(0, end);
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    line(text);
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
}

bool looks_like_iges(std::string_view bytes) {
  const std::string_view first = bytes.substr(0, bytes.find('\n'));
  return first.size() >= 73 && (first[72] == 'S' || first[72] == 'G' || first[72] == 'C');
}

/// Sections in order, and as many lines of each as the last line says.
void check_iges(std::string_view bytes, const std::string& path) {
  std::array<long long, 5> counted{};
  std::string last;
  long long number = 0;
  for_lines(bytes, [&](std::string_view line) {
    ++number;
    if (line.empty()) return;
    if (line.size() < 73 || line.size() > kIgesLine)
      throw FileError(path, number, fmt::format("an IGES line has {} characters, not 80", line.size()));
    const std::size_t section = kSections.find(line[72]);
    if (section == std::string_view::npos)
      throw FileError(path, number, "column 73 of an IGES line names no section (S, G, D, P or T)");
    ++counted[section];
    if (line[72] == 'T') last = line.substr(0, 72);
  });
  if (last.empty()) throw FileError(path, "the IGES file is cut off: its last section (T) is missing");
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string_view field = std::string_view(last).substr(8 * k, 8);
    const std::size_t start = std::min(field.find_first_not_of(' ', 1), field.size());
    const Index claimed = field.front() == kSections[k] ? parse_count(field.substr(start)) : -1;
    if (claimed != counted[k])
      throw FileError(path,
                      fmt::format("the IGES file is damaged: its section {} has {} lines, its last line says "
                                  "\"{}\"",
                                  kSections[k], counted[k], field));
  }
}

/// Text of the global section, without the ends of its lines.
std::string global_section(std::string_view bytes) {
  std::string text;
  for_lines(bytes, [&](std::string_view line) {
    if (line.size() > 72 && line[72] == 'G') text += line.substr(0, 72);
  });
  return text;
}

/// The parameters of a global section; Hollerith strings (4HINCH) may hold delimiters.
std::vector<std::string> global_parameters(std::string_view text) {
  std::vector<std::string> parameters(1);
  char delimiter = ',', end = ';';
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == 'H' && !parameters.back().empty()) {
      std::string_view digits = parameters.back();
      while (!digits.empty() && digits.front() == ' ') digits.remove_prefix(1);
      if (const Index length = parse_count(digits); length >= 0) {
        parameters.back() = text.substr(k + 1, static_cast<std::size_t>(length));
        k += static_cast<std::size_t>(length);
        if (parameters.size() == 1 && length == 1) delimiter = parameters.back().front();
        if (parameters.size() == 2 && length == 1) end = parameters.back().front();
        continue;
      }
    }
    if (text[k] == end && parameters.size() > 2) break;
    if (text[k] == delimiter)
      parameters.emplace_back();
    else
      parameters.back() += text[k];
  }
  return parameters;
}

CadUnit iges_unit(std::string_view bytes, const std::string& path) {
  const std::vector<std::string> parameters = global_parameters(global_section(bytes));
  std::string flag = parameters.size() > 13 ? parameters[13] : "";
  flag.erase(std::remove(flag.begin(), flag.end(), ' '), flag.end());
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
  const std::string_view head = bytes.substr(0, 1024), whole = trimmed_end(bytes);
  if (head.find("ISO-10303-21;") != std::string_view::npos) {
    if (!whole.ends_with("END-ISO-10303-21;"))
      throw FileError(path, "the STEP file is cut off: it does not end with END-ISO-10303-21;");
    return FileKind::step;
  }
  if (looks_like_iges(bytes)) {
    check_iges(whole, path);
    return FileKind::iges;
  }
  throw FileError(path, "is neither STEP (ISO-10303-21) nor IGES (80 columns)");
}

CadUnit unit_of(std::string_view bytes, FileKind kind, const std::string& path) {
  return kind == FileKind::step ? step_unit(bytes, path) : iges_unit(bytes, path);
}

}  // namespace knotfit::cad
