// ESRI ASCII grids: a header of keywords and values, then rows of heights from north to south.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <ostream>
#include <utility>

#include "formats/missing.h"
#include "formats/nodata.h"
#include "formats/number.h"
#include "formats/readers.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
#include "knotfit/io.h"
#include "knotfit/remedy.h"
namespace knotfit {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

enum Key { ncols, nrows, xllcorner, xllcenter, yllcorner, yllcenter, cellsize, dx, dy, nodata, kKeys };
constexpr std::array<std::string_view, kKeys> kNames = {"ncols",     "nrows",       "xllcorner", "xllcenter",
                                                        "yllcorner", "yllcenter",   "cellsize",  "dx",
                                                        "dy",        "nodata_value"};

int key_of(std::string_view word) {
  const std::string lower = lower_case(word);
  for (int k = 0; k < kKeys; ++k)
    if (lower == kNames[static_cast<std::size_t>(k)]) return k;
  return lower == "nodata" ? nodata : -1;
}

/// Words of a text with the line each stands on.
class Words {
 public:
  explicit Words(std::string_view text) : p_(text.data()), end_(p_ + text.size()) {}
  /// Goes to the next word. \return false at the end of the text
  bool next() {
    for (; p_ < end_ && (is_blank(*p_) || *p_ == '\n'); ++p_)
      if (*p_ == '\n') ++line_;
    const char* begin = p_;
    while (p_ < end_ && !is_blank(*p_) && *p_ != '\n') ++p_;
    word_ = {begin, static_cast<std::size_t>(p_ - begin)};
    return !word_.empty();
  }
  std::string_view word() const { return word_; }
  Index line() const { return line_; }
  /// Text from the beginning of this word on.
  std::string_view rest() const { return {word_.data(), static_cast<std::size_t>(end_ - word_.data())}; }

 private:
  const char* p_;
  const char* end_;
  std::string_view word_;
  Index line_ = 1;
};

Index words_on_line(std::string_view text) {
  return count_numbers(text.substr(0, text.find('\n')));
}

class Header {
 public:
  explicit Header(const FileBytes& file) : file_(file) {}

  /// Reads keywords in any order; words then stands on the first height.
  void read(Words& words) {
    bool more = words.next();
    if (more && parse_number(words.word()).status != NumberStatus::not_a_number)
      fail(words.line(),
           "an ESRI grid begins with a header (ncols, nrows, ...), not with numbers; " + kPoints);
    while (more && parse_number(words.word()).status == NumberStatus::not_a_number) {
      const std::string_view word = words.word();
      const int key = key_of(word);
      if (key < 0 && is_hole_word(word) && columns > 0 && rows > 0) break;  // the first height
      if (key < 0) refuse_word(word, words.line());
      // "NODATA" may be the first height: more than its value follows on the line, or it was there already.
      if (key == nodata && columns > 0 && rows > 0 && is_hole_word(word) &&
          (line_[nodata] > 0 || words_on_line(words.rest()) != 2))
        break;
      if (line_[key] > 0)
        fail(words.line(), fmt::format("{} is there twice (first on line {})", kNames[key], line_[key]));
      line_[key] = words.line();
      if (!words.next() || words.line() != line_[key])
        fail(line_[key], fmt::format("{} has no value", kNames[key]));
      take(key, words);
      more = words.next();
    }
    has_data_ = more;
    first_data_line = words.line();
    check();
  }

  /// A height that is not there, whatever the header's nodata value is: a usual word for it, or the header's own.
  bool is_hole_word(std::string_view word) const {
    return is_missing_word(word) || (!hole_word_.empty() && lower_case(word) == hole_word_);
  }

  double value(Key key) const { return value_[key]; }
  bool has(Key key) const { return line_[key] > 0; }
  Index columns = 0, rows = 0;
  Index first_data_line = 0;
  bool has_data() const { return has_data_; }

  [[noreturn]] void fail(Index line, const std::string& what) const {
    throw FileError(file_.path(), line, what);
  }
  [[noreturn]] void fail(const std::string& what) const { throw FileError(file_.path(), what); }

 private:
  [[noreturn]] void refuse_word(std::string_view word, Index line) const {
    if (line_ == std::array<Index, kKeys>{})
      fail(line,
           fmt::format("not an ESRI grid: it begins with {}, not with ncols; {}", in_quotes(word), kPoints));
    fail(line, fmt::format("{} is neither a number nor a header keyword (ncols, nrows, xllcorner, xllcenter, "
                           "yllcorner, yllcenter, cellsize, dx, dy, NODATA_value)",
                           in_quotes(word)));
  }

  void take(int key, const Words& words) {
    if (key == ncols || key == nrows) {
      const Index count = parse_count(words.word());
      if (count < 1)
        fail(words.line(),
             fmt::format("{} is {}, not a whole number above 0", kNames[key], in_quotes(words.word())));
      (key == ncols ? columns : rows) = count;
      return;
    }
    const ParsedNumber number = parse_number(words.word());
    if (key == nodata && number.status == NumberStatus::not_a_number) {
      hole_word_ = lower_case(words.word());
      value_[key] = kNan;
      return;
    }
    if (number.status != NumberStatus::ok || (key != nodata && !std::isfinite(number.value)))
      fail(words.line(), fmt::format("{} is {}, not a finite number", kNames[key], in_quotes(words.word())));
    value_[key] = number.value;
    if ((key == cellsize || key == dx || key == dy) && !(number.value > 0))
      fail(words.line(), fmt::format("{} is {}: it must be above 0", kNames[key], words.word()));
  }

  void check() const {
    for (const Key key : {ncols, nrows})
      if (!has(key)) fail(fmt::format("the header has no {}", kNames[key]));
    for (const auto& [corner, centre] : {std::pair{xllcorner, xllcenter}, std::pair{yllcorner, yllcenter}}) {
      if (!has(corner) && !has(centre))
        fail(fmt::format("the header has neither {} nor {}", kNames[corner], kNames[centre]));
      if (has(corner) && has(centre))
        fail(line_[centre], fmt::format("the header has both {} and {}", kNames[corner], kNames[centre]));
    }
    if (has(cellsize) && (has(dx) || has(dy)))
      fail(line_[cellsize], "the header has both cellsize and dx or dy");
    if (!has(cellsize) && !(has(dx) && has(dy))) fail("the header has neither cellsize nor dx and dy");
  }

  const FileBytes& file_;
  static inline const std::string kPoints =
      "points, a line each, are read with " + remedy_text(Remedy::format, "csv") +
      " (in rows parted by blank lines: " + remedy_text(Remedy::format, "rows") + ")";

  std::string hole_word_;  ///< NODATA_value, where it is no number
  std::array<double, kKeys> value_{};
  std::array<Index, kKeys> line_{};
  bool has_data_ = false;
};

/// A line of heights that is not one row of the grid.
struct OddLine {
  Index line = 0, row = 0, count = 0;
};

/// Heights after the header. A line is a row; lines of other lengths are only taken where all
/// together have as many numbers as the grid and there are not as many lines as rows (long rows
/// wrapped over lines, which the format allows).
class Heights {
 public:
  Heights(const Header& header, double hole) : header_(header), hole_(hole) {
    z.reserve(static_cast<std::size_t>(header.columns * header.rows));
  }

  void read(std::string_view text) {
    const char* p = text.data();
    const char* const end = p + text.size();
    Index line = header_.first_data_line, count = 0;
    for (;;) {
      p = skip_blanks(p, end);
      if (p == end || *p == '\n') {
        if (count > 0) end_line(line, count);
        count = 0;
        if (p == end) break;
        ++p;
        ++line;
        continue;
      }
      p = take(p, end, line, count);
      ++count;
    }
    check();
  }

  std::vector<double> z;

 private:
  const char* take(const char* p, const char* end, Index line, Index count) {
    double value = 0;
    const char* next = parse_prefix(p, end, value);
    if (next == p || (next < end && !is_blank(*next) && *next != '\n')) {
      next = p;
      while (next < end && !is_blank(*next) && *next != '\n') ++next;
      const std::string_view word{p, static_cast<std::size_t>(next - p)};
      ParsedNumber number = parse_number(word);
      if (number.status == NumberStatus::not_a_number && header_.is_hole_word(word))
        number = {NumberStatus::ok, kNan};
      if (number.status != NumberStatus::ok)
        header_.fail(
            line,
            fmt::format("{}: {} is {}", place(count), in_quotes(word),
                        number.status == NumberStatus::too_large
                            ? "beyond the range of a double"
                            : "not a number; \"NODATA_value WORD\" in the header makes holes of a word"));
      value = number.value;
    }
    if (is_nodata(value, hole_)) value = kNan;
    if (std::isinf(value)) header_.fail(line, fmt::format("{}: a height is infinite", place(count)));
    if (static_cast<Index>(z.size()) == header_.columns * header_.rows) {
      if (odd_.line > 0) refuse_odd_line();
      header_.fail(line, fmt::format("more numbers than the {} rows of {} of the header", header_.rows,
                                     header_.columns));
    }
    z.push_back(value);
    return next;
  }

  std::string place(Index count) const {
    const Index row = static_cast<Index>(z.size()) / header_.columns + 1;
    return fmt::format("grid row {}, number {} of the line", row, count + 1);
  }

  void end_line(Index line, Index count) {
    ++lines_;
    if (count != header_.columns && odd_.line == 0) odd_ = {line, lines_, count};
  }

  [[noreturn]] void refuse_odd_line() const {
    header_.fail(odd_.line, fmt::format("grid row {} has {} number{}, but ncols is {}", odd_.row, odd_.count,
                                        odd_.count == 1 ? "" : "s", header_.columns));
  }

  void check() const {
    const Index size = static_cast<Index>(z.size());
    if (odd_.line > 0 && (size != header_.columns * header_.rows || lines_ == header_.rows))
      refuse_odd_line();
    if (size < header_.columns * header_.rows)
      header_.fail(
          fmt::format("the file ends after {} rows, but nrows is {}", size / header_.columns, header_.rows));
  }

  const Header& header_;
  double hole_;
  OddLine odd_;
  Index lines_ = 0;
};

}  // namespace

bool looks_like_esri_ascii(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  Words words(text.substr(0, 200));
  return words.next() && key_of(words.word()) >= 0 && words.next();
}

SourceData read_esri_ascii(const FileBytes& file, const ReadOptions& options) {
  Words words(text_of(file));
  Header header(file);
  header.read(words);
  const std::string_view data = header.has_data() ? words.rest() : std::string_view();
  // Every number takes a byte and what parts it from the next.
  const Index most = static_cast<Index>(data.size() / 2 + 1);
  if (header.columns > most || header.rows > most / header.columns + 1)
    throw FileError(file.path(), fmt::format("the header claims {} x {} numbers, but only {} bytes follow",
                                             header.columns, header.rows, data.size()));

  // -9999 is the format's own default.
  // NaN is a hole anyway.
  const bool given = options.nodata && !std::isnan(*options.nodata);
  const double hole = given ? *options.nodata : header.has(nodata) ? header.value(nodata) : -9999;
  Heights heights(header, hole);
  heights.read(data);
  Raster raster;
  raster.columns = header.columns;
  raster.rows = header.rows;
  raster.dx = header.value(header.has(cellsize) ? cellsize : dx);
  raster.dy = header.value(header.has(cellsize) ? cellsize : dy);
  raster.x0 = header.has(xllcorner) ? header.value(xllcorner) : header.value(xllcenter) - 0.5 * raster.dx;
  raster.y0 = header.has(yllcorner) ? header.value(yllcorner) : header.value(yllcenter) - 0.5 * raster.dy;
  if (std::isfinite(hole)) raster.nodata = hole;
  raster.z = std::move(heights.z);
  return {file.path(), "esri-ascii", std::move(raster)};
}

namespace {

/// The raster's own nodata value, or another where a height has that very value.
double free_nodata(const Raster& raster) {
  for (const double candidate : {raster.nodata, -9999.0, -99999.0, -9999999.0, -1e30}) {
    if (!std::isfinite(candidate)) continue;
    bool taken = false;
    for (const double z : raster.z) taken = taken || is_nodata(z, candidate);
    if (!taken) return candidate;
  }
  throw InvalidInput("every usual nodata value is also a height of the raster; give it another nodata value");
}

}  // namespace

void write_raster(std::ostream& out, const Raster& raster) {
  if (raster.columns < 1 || raster.rows < 1 ||
      raster.z.size() != static_cast<std::size_t>(raster.columns) * static_cast<std::size_t>(raster.rows))
    throw InvalidInput(fmt::format("a raster of {} x {} cells has {} heights", raster.columns, raster.rows,
                                   raster.z.size()));
  if (!(raster.dx > 0 && raster.dy > 0) || !std::isfinite(raster.dx + raster.dy + raster.x0 + raster.y0))
    throw InvalidInput(
        fmt::format("a raster with cells of {} x {} at {}, {}: the cells must be above 0 and all finite",
                    raster.dx, raster.dy, raster.x0, raster.y0));
  for (std::size_t k = 0; k < raster.z.size(); ++k)
    if (std::isinf(raster.z[k])) throw InvalidInput(fmt::format("height {} of the raster is infinite", k));

  const double hole = free_nodata(raster);
  std::string text = fmt::format("ncols {}\nnrows {}\n", raster.columns, raster.rows);
  const auto line = [&](std::string_view key, double value) {
    text += key;
    text += ' ';
    append_number(text, value);
    text += '\n';
  };
  line("xllcorner", raster.x0);
  line("yllcorner", raster.y0);
  if (raster.dx == raster.dy) {
    line("cellsize", raster.dx);
  } else {
    line("dx", raster.dx);
    line("dy", raster.dy);
  }
  line("NODATA_value", hole);
  for (Index r = 0; r < raster.rows; ++r) {
    for (Index c = 0; c < raster.columns; ++c) {
      const double z = raster.z[static_cast<std::size_t>(r * raster.columns + c)];
      append_number(text, std::isnan(z) ? hole : z);
      text += c + 1 < raster.columns ? ' ' : '\n';
    }
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    text.clear();
  }
}

}  // namespace knotfit
