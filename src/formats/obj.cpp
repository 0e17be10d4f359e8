// Wavefront OBJ: v, vt, f; what belongs to looks, groups and free-form curves is left out.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "formats/mesh_builder.h"
#include "formats/missing.h"
#include "formats/number.h"
#include "formats/readers.h"
#include "formats/text_numbers.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr std::string_view kIgnored =
    " vn vp g o s mg p l usemtl mtllib usemap maplib bevel c_interp d_interp lod shadow_obj trace_obj ctech "
    "stech "
    "cstype deg bmat step curv curv2 surf parm trim hole scrv sp end con bsp bzp cdc res call csh ";

/// Lines without their comments, those that end with a backslash joined with the next.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text) : lines_(text) {}
  bool next(TextLine& line) {
    if (!lines_.next(line)) return false;
    strip(line.text);
    if (!line.text.ends_with('\\')) return true;
    joined_.assign(line.text.substr(0, line.text.size() - 1));
    TextLine more;
    while (lines_.next(more)) {
      strip(more.text);
      const bool goes_on = more.text.ends_with('\\');
      joined_ += ' ';
      joined_ += more.text.substr(0, more.text.size() - (goes_on ? 1 : 0));
      if (!goes_on) break;
    }
    line.text = trimmed(joined_);
    return true;
  }

 private:
  static void strip(std::string_view& text) { text = trimmed(text.substr(0, text.find('#'))); }
  LineReader lines_;
  std::string joined_;
};

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/// A line's first word, in small letters, and the rest.
std::pair<std::string, std::string_view> split_word(std::string_view line) {
  const char* const end = line.data() + line.size();
  const char* stop = line.data();
  while (stop < end && !is_blank(*stop)) ++stop;
  const auto length = static_cast<std::size_t>(stop - line.data());
  return {lower_case(line.substr(0, length)), line.substr(length)};
}

class ObjReader {
 public:
  ObjReader(const FileBytes& file, const ReadOptions& options)
      : file_(file), options_(options), text_(text_of(file)), builder_(file, 1) {}

  SourceData read() {
    count_lines();
    if (vertices_ == 0) {
      const std::string kind = foreign_kind(file_.view());
      throw FileError(file_.path(), fmt::format("is not an OBJ mesh: it has no vertex (v) line{}",
                                                kind.empty() ? "" : " and begins like " + kind));
    }
    builder_.reserve(vertices_, triangles_, true);
    uv_.reserve(static_cast<std::size_t>(2 * parameters_));
    read_vertices();
    // Points with as many parameters: one each.
    if (faces_ == 0 && parameters_ == vertices_)
      for (std::size_t k = 0; k < uv_.size(); k += 2) builder_.add_parameters(uv_[k], uv_[k + 1]);
    if (faces_ == 0) return points();
    read_faces();
    Mesh mesh = builder_.finish();
    add_notes();
    return {.path = file_.path(), .format = "obj", .content = std::move(mesh), .notes = notes_};
  }

 private:
  void add_notes() {
    const std::vector<std::string> said = builder_.notes();
    notes_.insert(notes_.end(), said.begin(), said.end());
  }

  void count_lines() {
    Index unknown = 0, first = 0;
    std::string name;
    ObjLines lines(text_);
    TextLine line;
    while (lines.next(line)) {
      const auto [word, rest] = split_word(line.text);
      if (word == "v") {
        ++vertices_;
      } else if (word == "vt") {
        ++parameters_;
      } else if (word == "f" || word == "fo") {
        ++faces_;
        triangles_ += std::max<Index>(count_numbers(rest) - 2, 0);
      } else if (!word.empty() && kIgnored.find(fmt::format(" {} ", word)) == std::string_view::npos) {
        if (!is_letter(word[0]))
          throw FileError(
              file_.path(), static_cast<long long>(line.number),
              fmt::format("{} is no keyword of an OBJ file", in_quotes(line.text.substr(0, word.size()))));
        if (unknown++ == 0) first = line.number, name = in_quotes(line.text.substr(0, word.size()));
      }
    }
    if (unknown > 0)
      notes_.push_back(fmt::format("line {}: {} is no keyword of an OBJ file: {} left out", first, name,
                                   unknown == 1 ? "the line is" : fmt::format("{} such lines are", unknown)));
  }

  void read_vertices() {
    ObjLines lines(text_);
    TextLine line;
    while (lines.next(line)) {
      const auto [word, rest] = split_word(line.text);
      if (word == "v") {
        LineNumbers numbers(file_, line, rest, "vertex");
        double xyz[3];
        for (double& x : xyz) x = faces_ == 0 ? number_or_none(numbers, line) : numbers.number();
        if (faces_ == 0) check_point(xyz);
        builder_.add_vertex(xyz, line.number);  // a weight or a colour may follow
      } else if (word == "vt") {
        LineNumbers numbers(file_, line, rest, "texture vertex");
        uv_.push_back(numbers.number_or_nan());
        uv_.push_back(numbers.at_end() ? 0 : numbers.number_or_nan());
      }
    }
  }

  /// Of a point without faces: NaN where the value is missing, and may be.
  double number_or_none(LineNumbers& numbers, const TextLine& line) const {
    const std::string_view word = numbers.token();
    const ParsedNumber parsed = parse_number(word);
    const bool read = parsed.status == NumberStatus::ok;
    if (read && std::isfinite(parsed.value)) return parsed.value;
    if (!read && !is_missing_word(word)) return LineNumbers(file_, line, word, "vertex").number();
    if (!options_.nodata || !std::isnan(*options_.nodata))
      builder_.fail(line.number,
                    fmt::format("vertex: {} is not a finite number; {}", in_quotes(word), leave_out_hint()));
    return *options_.nodata;
  }

  /// A point that is to be left out gets a place until then.
  void check_point(double* xyz) {
    const bool finite = std::isfinite(xyz[0]) && std::isfinite(xyz[1]) && std::isfinite(xyz[2]);
    if (!misses_value(xyz[2], finite, options_.nodata)) return;
    missing_.push_back(builder_.vertex_count());
    std::fill_n(xyz, 3, 0.0);
  }

  SourceData points() {
    SourceData data{.path = file_.path(), .format = "obj", .content = PointTable{}};
    PointTable table = builder_.points();
    add_notes();
    data.notes = notes_;
    drop_points(table, missing_);
    data.left_out = static_cast<Index>(missing_.size()) + drop_far_nodata(table, options_.nodata);
    if (table.z.empty()) throw FileError(file_.path(), "every point has the nodata value");
    if (data.left_out > 0) data.notes.push_back(left_out_note(data.left_out, *options_.nodata));
    data.content = std::move(table);
    return data;
  }

  void read_faces() {
    ObjLines lines(text_);
    TextLine line;
    Index vertices = 0, parameters = 0;  // so far: what negative numbers count back from
    std::vector<std::int32_t> corners;
    while (lines.next(line)) {
      const auto [word, rest] = split_word(line.text);
      vertices += word == "v";
      parameters += word == "vt";
      if (word != "f" && word != "fo") continue;
      corners.clear();
      LineNumbers tokens(file_, line, rest, "face");
      while (!tokens.at_end()) {
        const std::string_view token = tokens.token();
        const std::size_t slash = token.find('/');
        const auto [v, wrong] = index(token.substr(0, slash), "vertex", vertices, vertices_, line);
        if (v < 0) builder_.fail(line.number, wrong);
        corners.push_back(static_cast<std::int32_t>(v));
        if (slash == std::string_view::npos) continue;
        const std::string_view tail = token.substr(slash + 1);
        const std::string_view vt = tail.substr(0, tail.find('/'));
        if (vt.empty()) continue;
        const auto [t, no_such] = index(vt, "texture vertex", parameters, parameters_, line);
        if (t < 0)
          builder_.drop_parameters(fmt::format("line {}: {}", line.number, no_such));
        else
          builder_.set_corner_parameters(corners.back(), uv_[2 * static_cast<std::size_t>(t)],
                                         uv_[2 * static_cast<std::size_t>(t) + 1]);
      }
      builder_.check_corners(static_cast<Index>(corners.size()), vertices_, line.number);
      builder_.add_face(corners, line.number, vertices_);
    }
  }

  /// From 0, of a number from 1 or one that counts back from the last so far; -1 and why where there is none.
  std::pair<Index, std::string> index(std::string_view token, const char* what, Index so_far, Index there_are,
                                      const TextLine& line) const {
    Index k = 0;
    const auto [next, error] = std::from_chars(token.data(), token.data() + token.size(), k);
    const auto face = builder_.face_count() + 1;
    if (error != std::errc() || next != token.data() + token.size())
      builder_.fail(line.number, fmt::format("face {} (counted from 1): {} is no number of a {}", face,
                                             in_quotes(token), what));
    const Index at = k < 0 ? so_far + k : k - 1;
    if (at >= 0 && at < there_are) return {at, ""};
    return {-1, fmt::format("face {} (counted from 1) names {} {}, but {}", face, what, k,
                            k < 0 ? fmt::format("only {} stand before it", so_far)
                                  : fmt::format("there are {}, counted from 1", there_are))};
  }

  const FileBytes& file_;
  const ReadOptions& options_;
  std::string_view text_;
  MeshBuilder builder_;
  Index vertices_ = 0, parameters_ = 0, faces_ = 0, triangles_ = 0;
  std::vector<double> uv_;      // of vt lines; NaN: not finite, or no number
  std::vector<Index> missing_;  // of points without faces
  std::vector<std::string> notes_;
};

}  // namespace

SourceData read_obj(const FileBytes& file, const ReadOptions& options) {
  return ObjReader(file, options).read();
}

}  // namespace knotfit
