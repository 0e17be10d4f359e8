// OFF: vertices and polygons, with what a prefix adds to the vertices [Geomview].
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "formats/mesh_builder.h"
#include "formats/number.h"
#include "formats/readers.h"
#include "formats/text_numbers.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

class OffReader {
 public:
  explicit OffReader(const FileBytes& file)
      : file_(file), text_(checked_text(file)), lines_(text_), builder_(file, 0) {}

  SourceData read() {
    read_header();
    // "0 0 0" and a line end, "3 0 1 2" and a line end; on one line a blank.
    check_claim(file_, vertices_, "vertices", 6, body_.size());
    check_claim(file_, faces_, "faces", 8, body_.size());
    if (const auto layout = find_layout())
      read_numbers(*layout);
    else
      read_lines();
    SourceData data{.path = file_.path(), .format = "off", .content = PointTable{}};
    if (faces_ == 0)
      data.content = builder_.points();
    else
      data.content = builder_.finish();
    data.notes = notes_;
    for (const std::string& note : builder_.notes()) data.notes.push_back(note);
    return data;
  }

 private:
  static std::string_view checked_text(const FileBytes& file) {
    if (const std::string kind = foreign_kind(file.view()); !kind.empty())
      throw FileError(file.path(), "is not an OFF file: it begins like " + kind);
    if (file.view().substr(0, 200).find("BINARY") != std::string_view::npos)
      throw FileError(file.path(), "binary OFF is not read; save it as text");
    return text_of(file);
  }

  /// The keyword, if there is one, and two counts or three; what follows them is the body.
  void read_header() {
    TextLine line = content("the counts of vertices and faces");
    std::string_view rest = line.text;
    if (const std::size_t end = keyword_length(line); end > 0) rest = trimmed(line.text.substr(end));
    const char* stop = rest.data();
    const auto token = [&](bool needed) -> std::string_view {
      if (rest.empty() && needed) {
        line = content("the counts of vertices and faces");
        rest = line.text;
      }
      const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
      stop = word.data() + word.size();
      rest = trimmed(rest.substr(word.size()));
      return word;
    };
    const auto count = [&](const char* what) {
      const std::string_view word = token(true);
      const Index n = parse_count(word);
      if (n < 0) fail(line, fmt::format("the count of {} is {}", what, in_quotes(word)));
      return n;
    };
    vertices_ = count("vertices");
    const Index first = line.number;
    faces_ = count("faces");
    // The edges are of no use, and often 0 or missing. A count each on a line of its own has all three.
    if (!rest.empty() || line.number != first) token(true);
    own_line_ = rest.empty();
    body_ = own_line_ ? lines_.rest() : text_.substr(static_cast<std::size_t>(stop - text_.data()));
    if (vertices_ == 0) fail(line, "the header claims 0 vertices");
    header_line_ = line;
  }

  /// Numbers of a vertex beside its place, and of a face beside its corners, all of them alike.
  struct Layout {
    Index vertex = 0, face = 0;
  };

  /// Where the lines are not those of vertices and faces, one each: the numbers all the same, as on one line.
  std::optional<Layout> find_layout() {
    if (own_line_) {
      LineReader lines(body_);
      TextLine line;
      Index count = 0;
      while (lines.next(line)) count += !trimmed(line.text.substr(0, line.text.find('#'))).empty();
      if (count == vertices_ + faces_) return std::nullopt;
    }
    LineReader lines(body_);
    TextLine line;
    while (lines.next(line))
      for (const std::string_view word :
           split_fields(line.text.substr(0, line.text.find('#')), Separator::blanks)) {
        const ParsedNumber parsed = parse_number(word);
        numbers_.push_back(parsed.status == NumberStatus::ok ? parsed.value : NAN);
      }
    const Index usual = (normal_ ? 3 : 0) + (colour_ ? 4 : 0) + (texture_ ? 2 : 0);
    for (const Index vertex : {usual, usual - (colour_ ? 1 : 0), Index{0}, Index{3}, Index{4}})
      for (const Index face : {Index{0}, Index{3}, Index{4}, Index{1}})
        if (const Layout layout{vertex, face}; vertex >= (texture_ ? 2 : 0) && fits(layout)) return layout;
    if (!own_line_)
      fail(header_line_,
           fmt::format("the {} numbers after the counts are not those of {} vertices and {} faces",
                       numbers_.size(), vertices_, faces_));
    numbers_.clear();
    return std::nullopt;
  }

  bool fits(const Layout& layout) const {
    const auto all = static_cast<Index>(numbers_.size());
    const double start = static_cast<double>(vertices_) * static_cast<double>(3 + layout.vertex);
    if (start > static_cast<double>(all)) return false;
    auto at = static_cast<Index>(start);
    for (Index f = 0; f < faces_; ++f) {
      if (at >= all) return false;
      const double corners = numbers_[at];
      if (!(corners >= 1 && corners <= static_cast<double>(all - at - 1)) || corners != std::floor(corners))
        return false;
      for (Index k = at + 1; k <= at + static_cast<Index>(corners); ++k)
        if (!(numbers_[k] >= 0 && numbers_[k] < static_cast<double>(vertices_)) ||
            numbers_[k] != std::floor(numbers_[k]))
          return false;
      at += 1 + static_cast<Index>(corners) + layout.face;
    }
    return at == all;
  }

  void read_numbers(const Layout& layout) {
    builder_.reserve(vertices_, static_cast<Index>(numbers_.size()) / 4, false);
    const double* at = numbers_.data();
    for (Index k = 0; k < vertices_; ++k) {
      builder_.add_vertex(at, 0);
      at += 3 + layout.vertex;
      if (texture_) builder_.add_parameters(at[-2], at[-1]);
    }
    for (Index k = 0; k < faces_; ++k) {
      const auto count = static_cast<Index>(*at);
      builder_.check_corners(count, vertices_, 0);
      corners_.assign(at + 1, at + 1 + count);
      builder_.add_face(corners_, 0, vertices_);
      at += 1 + count + layout.face;
    }
  }

  void read_lines() {
    builder_.reserve(vertices_, 0, true);
    for (Index k = 0; k < vertices_; ++k) read_vertex(k);
    builder_.reserve(0, count_numbers(lines_.rest()) - 3 * faces_, true);
    for (Index k = 0; k < faces_; ++k) read_face(k);
    TextLine line;
    Index after = 0, first = 0;
    while (next(line))
      if (after++ == 0) first = line.number;
    if (after > 0)
      notes_.push_back(
          fmt::format("{} after the last of {} faces that the header claims, from line {}: left out",
                      after == 1 ? "a line" : fmt::format("{} lines", after), faces_, first));
  }

  [[noreturn]] void fail(const TextLine& line, const std::string& message) const {
    throw FileError(file_.path(), static_cast<long long>(line.number), message);
  }

  bool next(TextLine& line) {
    while (lines_.next(line)) {
      line.text = trimmed(line.text.substr(0, line.text.find('#')));
      if (!line.text.empty()) return true;
    }
    return false;
  }

  TextLine content(const std::string& wanted) {
    TextLine line;
    if (!next(line)) throw FileError(file_.path(), "the file ends before " + wanted);
    return line;
  }

  /// Of [ST][C][N][4][n]OFF at the line's beginning, in any case; the counts may follow it without a blank, "OFF8 6
  /// 12". 0: there is none, the counts come at once.
  std::size_t keyword_length(const TextLine& line) {
    const std::size_t end = std::min(line.text.find_first_of(" \t"), line.text.size());
    const std::string_view first = line.text.substr(0, end);
    if (parse_number(first).status != NumberStatus::not_a_number) return 0;
    const std::string lower = lower_case(first.substr(0, 16));
    const std::size_t off = lower.find("off");
    if (off == std::string::npos || (off + 3 < first.size() && parse_count(first.substr(off + 3)) < 0))
      fail(line, fmt::format("{} is not OFF, nor a count of vertices", in_quotes(first)));
    std::string_view word = first.substr(0, off);
    // Small letters throughout: n is N, normals; before OFF it says how many coordinates there are.
    const std::string prefix = first.substr(off, 3) == "off" ? upper_case(word) : std::string(word);
    word = prefix;
    const auto takes = [&](std::string_view kind) {
      const bool there = word.starts_with(kind);
      if (there) word.remove_prefix(kind.size());
      return there;
    };
    texture_ = takes("ST");
    colour_ = takes("C");
    normal_ = takes("N");
    colour_ = takes("C") || colour_;
    if (word == "4" || word == "n" || word == "4n" || word == "4N")
      fail(line, "vertices of another number of coordinates than three are not read");
    if (!word.empty()) fail(line, fmt::format("{} is no kind of OFF", in_quotes(first)));
    return off + 3;
  }

  static std::string upper_case(std::string_view text) {
    std::string out(text);
    for (char& c : out)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return out;
  }

  void read_vertex(Index k) {
    const TextLine line =
        content(fmt::format("vertex {} (counted from 0) of the {} that the header claims", k, vertices_));
    LineNumbers numbers(file_, line, line.text, "vertex");
    double xyz[3];
    for (double& x : xyz) x = numbers.number();
    builder_.add_vertex(xyz, line.number);
    if (!texture_) return;
    // Normals and colours stand between the place and the parameters.
    double last[2] = {0, 0};
    Index more = 0;
    for (; !numbers.at_end(); ++more) {
      last[0] = last[1];
      last[1] = numbers.number_or_nan();
    }
    if (more < 2) fail(line, "the vertex has no texture coordinates s, t, which STOFF has");
    builder_.add_parameters(last[0], last[1]);
  }

  void read_face(Index k) {
    const TextLine line =
        content(fmt::format("face {} (counted from 0) of the {} that the header claims", k, faces_));
    LineNumbers numbers(file_, line, line.text, "face");
    const std::string_view token = numbers.token();
    const Index n = parse_count(token);
    if (n < 0) fail(line, fmt::format("the face's number of corners is {}", in_quotes(token)));
    if (2 * n > static_cast<Index>(line.text.size()))
      fail(line, fmt::format("the face has too few numbers for {} corners", n));
    builder_.check_corners(n, vertices_, line.number);
    corners_.clear();
    for (Index i = 0; i < n; ++i)
      corners_.push_back(builder_.corner(numbers.number(), vertices_, line.number));
    // A colour may follow, of any kind.
    builder_.add_face(corners_, line.number, vertices_);
  }

  const FileBytes& file_;
  std::string_view text_;
  LineReader lines_;
  std::string_view body_;  // what follows the counts
  bool own_line_ = true;   // the body begins on a line of its own
  TextLine header_line_;   // the last of the counts
  MeshBuilder builder_;
  Index vertices_ = 0, faces_ = 0;
  bool texture_ = false, colour_ = false, normal_ = false;
  std::vector<std::int32_t> corners_;
  std::vector<double> numbers_;
  std::vector<std::string> notes_;
};

}  // namespace

SourceData read_off(const FileBytes& file, const ReadOptions&) {
  return OffReader(file).read();
}

}  // namespace knotfit
