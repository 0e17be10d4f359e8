#include "formats/text_opening.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <optional>

#include "formats/airfoil.h"
#include "formats/column_guess.h"
#include "formats/missing.h"
#include "formats/number.h"
#include "formats/point_line.h"
#include "knotfit/exceptions.h"
#include "knotfit/remedy.h"
namespace knotfit {
namespace {

constexpr std::size_t kAhead = 64;    // lines looked at
constexpr std::size_t kLeading = 40;  // of them before the data, at most

using Fields = std::vector<std::string_view>;

bool is_number(std::string_view field) {
  return parse_number(field).status != NumberStatus::not_a_number;
}
bool is_value(std::string_view field) {
  return is_number(field) || is_missing_word(field);
}
bool none_is_number(const Fields& fields) {
  return std::none_of(fields.begin(), fields.end(), is_number);
}

/// Text, not a number with a slip in it: two letters side by side, or one letter alone.
bool is_word(std::string_view field) {
  const auto letter = [](char c) {
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80;
  };
  if (is_value(field)) return false;
  if (field.size() == 1) return letter(field[0]);
  for (std::size_t k = 1; k < field.size(); ++k)
    if (letter(field[k - 1]) && letter(field[k])) return true;
  return false;
}

/// A whole number of points, such as "40." \return 0 where it is none
Index count_of(std::string_view field) {
  const ParsedNumber n = parse_number(field);
  const bool whole =
      n.status == NumberStatus::ok && n.value >= 1 && n.value < 1e15 && n.value == std::floor(n.value);
  return whole ? static_cast<Index>(n.value) : 0;
}

std::string list_of(const Fields& fields) {
  std::string out;
  for (std::size_t i = 0; i < fields.size() && i < 12; ++i) out += (i > 0 ? ", " : "") + in_quotes(fields[i]);
  return out + (fields.size() > 12 ? ", ..." : "");
}

Index content_lines(LineReader lines) {
  Index count = 0;
  TextLine line;
  while (lines.next(line)) count += !is_empty_line(line.text) && !is_comment(line.text);
  return count;
}

/// A line with content, and what stands before and after it.
struct Ahead {
  TextLine line;
  LineReader after;
  std::size_t comments = 0;  ///< before it
  bool gap = false;          ///< a blank line stands before it
};

class Opener {
 public:
  Opener(const FileBytes& file, const ReadOptions& options) : file_(file), options_(options) {
    if (!options.columns.empty()) {
      out_.columns = columns_of_option(options.columns, options.places);
      out_.columns_from = "option";
    }
    look_ahead(text_of(file));
  }

  TextOpening open() {
    Index last_header = 0;
    for (std::size_t at = 0; at < ahead_.size(); ++at) {
      if (at >= kLeading || !leads(at)) {
        take_data(at);
        return std::move(out_);
      }
      if (out_.header) last_header = ahead_[at].line.number;
    }
    throw FileError(file_.path(),
                    last_header > 0
                        ? fmt::format("there is no data line after the header (line {})", last_header)
                        : std::string("there is no line with data"));
  }

 private:
  void look_ahead(std::string_view text) {
    LineReader lines(text);
    TextLine line;
    for (Index k = 0; k < options_.skip_lines; ++k)
      if (!lines.next(line))
        throw FileError(file_.path(),
                        fmt::format("{} lines are to be skipped, but there are {}", options_.skip_lines, k));
    bool gap = false;
    while (ahead_.size() < kAhead && lines.next(line)) {
      if (is_empty_line(line.text)) {
        gap = true;
      } else if (is_comment(line.text)) {
        comments_.push_back(
            trimmed(line.text.substr(std::min(line.text.find_first_not_of("#%/"), line.text.size()))));
      } else if (!lower_case(line.text).starts_with("sep=")) {  // a spreadsheet's note on its separator
        ahead_.push_back({line, lines, comments_.size(), gap});
        gap = false;
      }
    }
  }

  Fields fields(std::size_t at, Separator separator) const {
    return split_fields(ahead_[at].line.text, separator);
  }
  Fields fields(std::size_t at) const { return fields(at, find_separator(ahead_[at].line.text)); }

  /// The columns of a line with data; 0: it is none.
  std::size_t data_columns(std::size_t at) const {
    if (at >= ahead_.size()) return 0;
    Fields f = fields(at);
    const std::vector<Role>& roles = out_.columns.roles;
    if (roles.empty()) {
      const bool data = std::all_of(f.begin(), f.end(), is_value) && !none_is_number(f);
      if (data || find_separator(ahead_[at].line.text) != Separator::tab) return data ? f.size() : 0;
      f = fields(at, Separator::blanks);  // blanks and tabs, mixed
      return std::all_of(f.begin(), f.end(), is_value) && !none_is_number(f) ? f.size() : 0;
    }
    if (f.size() != roles.size()) f = fields(at, Separator::blanks);
    bool number = false;
    for (std::size_t k = 0; k < f.size() && k < roles.size(); ++k) {
      if (roles[k] == Role::skip) continue;
      if (!is_value(f[k])) return 0;
      number = number || is_number(f[k]);
    }
    return f.size() == roles.size() && number ? f.size() : 0;
  }

  /// The columns where this line and the next are data alike; 0 else.
  std::size_t data_from(std::size_t at) const {
    const std::size_t columns = data_columns(at);
    return columns >= 2 && data_columns(at + 1) == columns ? columns : 0;
  }

  bool is_usable_header(std::size_t at) const {
    if (out_.header || at >= ahead_.size()) return false;
    const Fields f = fields(at);
    return objection(columns_of_header(f).roles, options_.places).empty();
  }

  /// Where data begins after line `at`, or a header above data; `at` where it does not.
  std::size_t next_data(std::size_t at) const {
    for (std::size_t k = at + 1; k < ahead_.size() && k <= at + kLeading; ++k)
      if (data_from(k) > 0 || (is_usable_header(k) && none_is_number(fields(k)))) return k;
    return at;
  }

  /// Whether a line stands before the data; a header is taken, what else there is is noted.
  bool leads(std::size_t at) { return out_.columns_from == "option" ? leads_named(at) : leads_unnamed(at); }

  bool leads_named(std::size_t at) {
    const std::vector<Role>& roles = out_.columns.roles;
    const Fields f = fields(at);
    bool numbers = false;
    for (std::size_t i = 0; i < f.size() && i < roles.size(); ++i)
      numbers = numbers || (roles[i] != Role::skip && is_value(f[i]));
    if (!out_.header && !numbers && (f.size() == roles.size() || none_is_number(f)) &&
        !title_over_header(at)) {
      out_.header = true;
      return true;
    }
    return data_columns(at) == 0 && (is_units(at) || is_title(at) || is_count(at));
  }

  bool leads_unnamed(std::size_t at) {
    const Fields f = fields(at);
    if (is_usable_header(at) && !title_over_header(at)) {
      out_.columns = columns_of_header(f);
      out_.columns_from = "header";
      out_.header = true;
      return true;
    }
    if (is_units(at) || is_count(at)) return true;
    if (out_.header) return false;
    if (is_title(at)) return true;
    const bool named = std::any_of(f.begin(), f.end(), [](auto x) { return role_of(x) != Role::skip; });
    if (named || (none_is_number(f) && !std::all_of(f.begin(), f.end(), is_value))) refuse_header(at, f);
    return false;
  }

  [[noreturn]] void refuse_header(std::size_t at, const Fields& f) const {
    const Index line = ahead_[at].line.number;
    throw FileError(
        file_.path(), line,
        fmt::format("{} in the header {}; name the columns with {}, or leave the line out "
                    "with {} where it names none",
                    objection(columns_of_header(f).roles, options_.places), list_of(f),
                    remedy_text(Remedy::columns), remedy_text(Remedy::skip_lines, std::to_string(line))));
  }

  /// The next line is a header, and this one has not as many words.
  bool title_over_header(std::size_t at) const {
    return is_usable_header(at + 1) && data_columns(at + 2) > 0 && fields(at).size() != fields(at + 1).size();
  }

  /// A line of units under the header.
  bool is_units(std::size_t at) {
    if (!out_.header || data_columns(at + 1) == 0) return false;
    const Fields f = fields(at);
    if (!none_is_number(f) || f.size() != out_.columns.roles.size() ||
        std::all_of(f.begin(), f.end(), is_value))
      return false;
    note(at, "a line of words under the header");
    return true;
  }

  /// Words that no data can be, above lines of data that agree.
  bool is_title(std::size_t at) {
    const std::size_t data = next_data(at);
    if (data == at) return false;
    const bool header = is_usable_header(data);
    const Separator separator = find_separator(ahead_[data].line.text);
    const std::size_t columns = header ? fields(data).size() : data_columns(data);
    const Fields f = fields(at, separator);
    if (std::none_of(f.begin(), f.end(), is_word)) return false;
    const auto numbers = std::count_if(f.begin(), f.end(), is_number);
    if (is_number(f.front()) && 2 * numbers >= static_cast<Index>(f.size())) return false;
    if (f.size() == columns && !header) {
      // As many words as columns: a name that holds numbers, or two words over the x, y of a curve.
      if (separator != Separator::blanks || is_value(f.front())) return false;
      if (none_is_number(f) && !(columns == 2 && options_.curve)) return false;
    }
    note(at, "a title");
    return true;
  }

  /// One number above lines of several; two that count rows and columns, or the surfaces of an airfoil.
  bool is_count(std::size_t at) {
    const Fields f = fields(at);
    if (f.size() > 2 || !std::all_of(f.begin(), f.end(), is_number)) return false;
    if (ahead_[at].line.text.find_first_of(",;") != std::string_view::npos && f.size() == 2) return false;
    const std::size_t columns = data_from(at + 1);
    if (columns < 2) return false;
    const Index there = content_lines(ahead_[at].after);
    if (f.size() == 1) {
      const Index count = count_of(f[0]);
      note(at, count == there ? "the number of points"
               : count > 0    ? fmt::format("a number alone, but {} points follow", there)
                              : "a number alone");
      return true;
    }
    const Index a = count_of(f[0]), b = count_of(f[1]);
    if (a == 0 || b == 0) return false;
    if (columns > 2) {
      if (a < 2 || b < 2 || a > there || b > there || a * b != there) return false;
      note(at, "the numbers of rows and columns");
      return true;
    }
    if (!options_.curve || a < 2 || b < 2) return false;
    const bool airfoil = a + b == there && is_lednicer(ahead_[at].after, a, b);
    // A line of its own, apart from the blocks that it counts.
    const bool apart = ahead_[at + 1].gap;
    if (!airfoil && !apart) return false;
    if (airfoil) out_.upper = a, out_.lower = b;
    note(at, "the numbers of points of two surfaces");
    return true;
  }

  void note(std::size_t at, const std::string& what) {
    const TextLine& line = ahead_[at].line;
    out_.notes.push_back(fmt::format("line {} left out, {}: {}", line.number, what, in_quotes(line.text)));
  }

  void take_data(std::size_t at) {
    const TextLine& line = ahead_[at].line;
    out_.separator = find_separator(line.text);
    Fields f = fields(at, out_.separator);
    if (out_.separator == Separator::tab && blanks_part(f, line.text)) {
      out_.separator = Separator::blanks;
      f = fields(at, out_.separator);
    }
    out_.first = line;
    out_.rest = ahead_[at].after;
    const std::size_t next = data_columns(at + 1), after = data_columns(at + 2);
    if (next > 0 && next == after && next != f.size() && !out_.header)
      out_.hint = fmt::format("; if line {} is no point, leave it out with {}", line.number,
                              remedy_text(Remedy::skip_lines, std::to_string(line.number)));
    if (out_.columns.empty()) find_columns(at, std::max(f.size(), empty_cell_at_end(at) ? next : 0));
    out_.origin = out_.columns_from == "option" ? fmt::format("{} are named", out_.columns.roles.size())
                  : out_.header ? fmt::format("the header names {}", out_.columns.roles.size())
                                : fmt::format("line {} has {}", line.number, out_.columns.roles.size());
  }

  /// The line ends with a separator, and the next has one more cell.
  bool empty_cell_at_end(std::size_t at) const {
    const std::string_view text = ahead_[at].line.text;
    const char mark = static_cast<char>(out_.separator);
    return out_.separator != Separator::blanks && text.ends_with(mark) &&
           data_columns(at + 1) == fields(at, out_.separator).size() + 1;
  }

  /// A blank inside a tab's field: tabs and blanks are mixed, and both part the columns.
  bool blanks_part(const Fields& f, std::string_view line) const {
    const std::size_t by_blanks = split_fields(line, Separator::blanks).size();
    const std::size_t wanted = out_.columns.roles.size();
    if (wanted > 0) return f.size() != wanted && by_blanks == wanted;
    return by_blanks != f.size();
  }

  void find_columns(std::size_t at, std::size_t columns) {
    // A comment before the data may be its header, as NumPy's savetxt and CloudCompare write it.
    for (std::size_t c = ahead_[at].comments; c-- > 0;) {
      const auto names = split_fields(comments_[c], find_separator(comments_[c]));
      if (names.size() != columns) continue;
      Columns named = columns_of_header(names);
      if (!objection(named.roles, options_.places).empty()) continue;
      out_.columns = std::move(named);
      out_.columns_from = "header";
      return;
    }
    out_.columns_from = "guess";
    if (columns == 2 && options_.curve) {
      out_.columns = {{Role::x, Role::y}, {"x", "y"}};
      return;
    }
    ColumnValues values(static_cast<Index>(columns));
    if (columns > 3 && columns <= 10) see_values(at, values);
    GuessedColumns guess = guess_columns(values, options_.any_parameters);
    if (guess.columns.empty()) throw FileError(file_.path(), out_.first.number, guess.why + out_.hint);
    out_.columns = std::move(guess.columns);
  }

  void see_values(std::size_t at, ColumnValues& values) const {
    std::vector<double> row(static_cast<std::size_t>(values.columns()));
    std::vector<double*> into;
    into.reserve(row.size());
    for (double& x : row) into.push_back(&x);
    TextLine line = ahead_[at].line;
    LineReader lines = ahead_[at].after;
    do {
      if (is_empty_line(line.text) || is_comment(line.text)) continue;
      if (parse_line(line, into, out_.separator)) values.take(row);
    } while (lines.next(line));
  }

  const FileBytes& file_;
  const ReadOptions& options_;
  TextOpening out_;
  std::vector<Ahead> ahead_;
  std::vector<std::string_view> comments_;
};

}  // namespace

bool is_empty_line(std::string_view line) {
  return line.find_first_not_of(",; \t\r\f\v") == std::string_view::npos;
}

TextOpening open_point_text(const FileBytes& file, const ReadOptions& options) {
  return Opener(file, options).open();
}

}  // namespace knotfit
