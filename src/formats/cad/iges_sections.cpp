#include "formats/cad/iges_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "formats/number.h"
#include "knotfit/exceptions.h"
#include "knotfit/knot_vector.h"
namespace knotfit::cad {
namespace {

constexpr std::size_t kLine = 80, kSection = 72;  ///< length, and where a line's section stands
constexpr double kLargest = 1e30;  ///< of any number: what squares and products of it may still hold
constexpr std::string_view kSections = "SGDPT";

/// Calls line(text, number) for each line without its end.
template <class Line>
void for_lines(std::string_view bytes, const Line& line) {
  for (long long number = 1; !bytes.empty(); ++number) {
    const std::size_t end = bytes.find('\n');
    std::string_view text = bytes.substr(0, end);
    if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
    line(text, number);
    bytes.remove_prefix(end == std::string_view::npos ? bytes.size() : end + 1);
  }
}

std::string_view without_blanks(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

std::string global_text(std::string_view bytes) {
  std::string text;
  for_lines(bytes, [&](std::string_view line, long long) {
    if (line.size() > kSection && line[kSection] == 'G') text += line.substr(0, kSection);
  });
  return text;
}

/// As many lines of each section as the last line says.
void check_sections(std::string_view bytes, const std::string& path) {
  std::array<Index, 5> counted{};
  std::string last;
  for_lines(bytes, [&](std::string_view line, long long number) {
    if (line.empty()) return;
    if (line.size() <= kSection || line.size() > kLine)
      throw FileError(path, number,
                      fmt::format("an IGES line has {} characters, not {}", line.size(), kLine));
    const std::size_t section = kSections.find(line[kSection]);
    if (section == std::string_view::npos)
      throw FileError(path, number, "column 73 of an IGES line names no section (S, G, D, P or T)");
    ++counted[section];
    if (line[kSection] == 'T') last = line.substr(0, kSection);
  });
  if (last.empty()) throw FileError(path, "the IGES file is cut off: its last section (T) is missing");
  for (std::size_t k = 0; k < 4; ++k) {
    const std::string_view field = std::string_view(last).substr(8 * k, 8);
    const Index claimed = field.front() == kSections[k] ? parse_count(without_blanks(field.substr(1))) : -1;
    if (claimed != counted[k])
      throw FileError(
          path, fmt::format("the IGES file is damaged: its section {} has {} lines, its last line says {}",
                            kSections[k], counted[k], in_quotes(field)));
  }
}

/// The parameters of one entity: its counts against how many there are.
class EntityCheck {
 public:
  EntityCheck(const std::string& path, long long line, std::vector<std::string_view> parameters)
      : path_(path), line_(line), parameters_(std::move(parameters)) {}

  void run() const {
    const std::string_view type = parameters_.empty() ? std::string_view() : without_blanks(parameters_[0]);
    if (type == "128") {
      const Index n = size(1), m = size(2), p = degree(3, n), q = degree(4, m);
      if (m > most() / n) refuse("more control points than numbers");
      want(10 + (n + p + 1) + (m + q + 1) + 4 * n * m + 4);
    } else if (type == "126") {
      const Index n = size(1), p = degree(2, n);
      want(7 + (n + p + 1) + 4 * n + 2);
    }
  }

 private:
  Index most() const { return static_cast<Index>(parameters_.size()); }
  Index count(std::size_t k) const {
    return k < parameters_.size() ? parse_count(without_blanks(parameters_[k])) : -1;
  }
  /// K + 1 basis functions.
  Index size(std::size_t k) const {
    const Index upper = count(k);
    if (upper < 1 || upper >= most()) refuse("a number of control points that cannot be");
    return upper + 1;
  }
  Index degree(std::size_t k, Index functions) const {
    const Index value = count(k);
    if (value < 1 || value >= functions) refuse("a degree that cannot be");
    return value;
  }
  void want(Index numbers) const {
    if (most() < numbers) refuse(fmt::format("{} numbers where its counts ask for {}", most(), numbers));
    for (Index k = 0; k < numbers; ++k) {
      const std::string_view token = without_blanks(parameters_[static_cast<std::size_t>(k)]);
      const ParsedNumber number = parse_number(token);
      if (number.status == NumberStatus::not_a_number) refuse(in_quotes(token) + " in place of a number");
      if (number.status == NumberStatus::too_large || !(std::abs(number.value) <= kLargest))
        refuse(in_quotes(token) + ", larger than any length may be");
    }
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw FileError(path_, line_, "the IGES spline (entity " + std::string(parameters_[0]) + ") has " + what);
  }

  const std::string& path_;
  long long line_;
  std::vector<std::string_view> parameters_;
};

struct Delimiters {
  char parameter = ',', record = ';';
};

Delimiters delimiters_of(const std::vector<std::string>& global) {
  Delimiters d;
  if (!global.empty() && global[0].size() == 1) d.parameter = global[0].front();
  if (global.size() > 1 && global[1].size() == 1) d.record = global[1].front();
  return d;
}

/// The first two parameters are nothing, or 1H and a delimiter: whoever guesses otherwise reads another file.
void check_delimiters(std::string_view bytes, const std::string& path) {
  const std::string text = global_text(bytes);
  std::size_t at = 0;
  char delimiter = ',';
  for (int k = 0; k < 2; ++k) {
    if (text.compare(at, 2, "1H") == 0 && text.size() > at + 3) {
      if (k == 0) delimiter = text[at + 2];
      at += 3;
    }
    if (at >= text.size() || text[at] != delimiter)
      throw FileError(path,
                      "the IGES file is damaged: its global section does not begin with its two delimiters");
    ++at;
  }
}

/// The parameter section, entity by entity: its lines name the directory line they belong to.
void check_splines(std::string_view bytes, const std::string& path) {
  const Delimiters delimiter = delimiters_of(iges_global_parameters(bytes));
  std::string record, owner;
  long long begin = 0;
  const auto finish = [&] {
    const std::string_view text = std::string_view(record).substr(0, record.find(delimiter.record));
    std::vector<std::string_view> parameters;
    if (without_blanks(text.substr(0, text.find(delimiter.parameter))).starts_with("12"))
      for (std::size_t at = 0; at <= text.size();) {
        const std::size_t end = std::min(text.find(delimiter.parameter, at), text.size());
        parameters.push_back(text.substr(at, end - at));
        at = end + 1;
      }
    EntityCheck(path, begin, std::move(parameters)).run();
    record.clear();
  };
  for_lines(bytes, [&](std::string_view line, long long number) {
    if (line.size() <= kSection || line[kSection] != 'P') return;
    const std::string_view of = line.substr(64, 8);
    if (of != owner) {
      finish();
      owner = of;
      begin = number;
    }
    record += line.substr(0, 64);
  });
  finish();
}

}  // namespace

bool looks_like_iges(std::string_view bytes) {
  const std::string_view first = bytes.substr(0, bytes.find('\n'));
  return first.size() > kSection && (first[kSection] == 'S' || first[kSection] == 'G');
}

void check_iges(std::string_view bytes, const std::string& path) {
  check_sections(bytes, path);
  check_delimiters(bytes, path);
  check_splines(bytes, path);
}

std::vector<std::string> iges_global_parameters(std::string_view bytes) {
  const std::string text = global_text(bytes);
  std::vector<std::string> parameters(1);
  Delimiters delimiter;
  for (std::size_t k = 0; k < text.size(); ++k) {
    std::string& last = parameters.back();
    const Index length = text[k] == 'H' ? parse_count(without_blanks(last)) : -1;
    if (length >= 0) {
      last = text.substr(k + 1, static_cast<std::size_t>(length));
      k += last.size();
      delimiter = delimiters_of(parameters);
    } else if (text[k] == delimiter.parameter) {
      parameters.emplace_back();
    } else if (text[k] == delimiter.record && parameters.size() > 2) {
      break;
    } else {
      last += text[k];
    }
  }
  return parameters;
}

}  // namespace knotfit::cad
