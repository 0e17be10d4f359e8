// OFF: vertices and polygons, with what a prefix adds to the vertices [Geomview].
#include <fmt/format.h>

#include <cmath>

#include "formats/mesh_builder.h"
#include "formats/number.h"
#include "formats/readers.h"
#include "formats/text_numbers.h"
#include "knotfit/errors.h"
namespace knotfit {
namespace {

class OffReader {
 public:
  explicit OffReader(const FileBytes& file)
      : file_(file), text_(checked_text(file)), lines_(text_), builder_(file, 0) {}

  SourceData read() {
    TextLine line = content("the counts of vertices and faces");
    std::string_view rest = line.text;
    if (const std::size_t end = keyword_length(line); end > 0) {
      rest = trimmed(line.text.substr(end));
      if (rest.empty()) {
        line = content("the counts of vertices and faces");
        rest = line.text;
      }
    }
    LineNumbers counts(file_, line, rest, "line of counts");
    vertices_ = count(counts, line, "vertices");
    faces_ = count(counts, line, "faces");
    if (!counts.at_end()) count(counts, line, "edges");  // of no use, and often 0
    if (!counts.at_end()) fail(line, "more than three counts");
    if (vertices_ == 0) fail(line, "the header claims 0 vertices");
    // "0 0 0" and a line end, "3 0 1 2" and a line end.
    check_claim(file_, vertices_, "vertices", 6, lines_.left());
    check_claim(file_, faces_, "faces", 8, lines_.left());
    builder_.reserve(vertices_, 0, true);
    for (Index k = 0; k < vertices_; ++k) read_vertex(k);
    builder_.reserve(0, count_numbers(lines_.rest()) - 3 * faces_, true);
    for (Index k = 0; k < faces_; ++k) read_face(k);
    if (next(line)) fail(line, fmt::format("data after the last of {} faces", faces_));
    if (faces_ == 0) return {file_.path(), "off", builder_.points()};
    return {file_.path(), "off", builder_.finish()};
  }

 private:
  static std::string_view checked_text(const FileBytes& file) {
    if (const std::string kind = foreign_kind(file.view()); !kind.empty())
      throw FileError(file.path(), "is not an OFF file: it begins like " + kind);
    if (file.view().substr(0, 200).find("BINARY") != std::string_view::npos)
      throw FileError(file.path(), "binary OFF is not read; save it as text");
    return text_of(file);
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

  /// Of [ST][C][N][4][n]OFF at the line's beginning. 0: there is none, the counts come at once.
  std::size_t keyword_length(const TextLine& line) {
    const std::size_t end = std::min(line.text.find_first_of(" \t"), line.text.size());
    std::string_view word = line.text.substr(0, end);
    if (parse_number(word).status != NumberStatus::not_a_number) return 0;
    if (!word.ends_with("OFF"))
      fail(line, fmt::format("{} is not OFF, nor a count of vertices", in_quotes(word)));
    word.remove_suffix(3);
    const auto takes = [&](std::string_view prefix) {
      const bool there = word.starts_with(prefix);
      if (there) word.remove_prefix(prefix.size());
      return there;
    };
    texture_ = takes("ST");
    takes("C");
    takes("N");
    if (word == "4" || word == "n" || word == "4n")
      fail(line, "vertices of another number of coordinates than three are not read");
    if (!word.empty()) fail(line, fmt::format("{} is no kind of OFF", in_quotes(line.text.substr(0, end))));
    return end;
  }

  Index count(LineNumbers& numbers, const TextLine& line, const char* what) {
    const std::string_view token = numbers.token();
    const Index n = parse_count(token);
    if (n < 0) fail(line, fmt::format("the count of {} is {}", what, in_quotes(token)));
    return n;
  }

  void read_vertex(Index k) {
    const TextLine line =
        content(fmt::format("vertex {} (counted from 0) of the {} that the header claims", k, vertices_));
    LineNumbers numbers(file_, line, line.text, "vertex");
    double xyz[3];
    for (double& x : xyz) x = numbers.number();
    // Normals and colours stand between the place and the parameters.
    double last[2] = {0, 0};
    Index more = 0;
    for (; !numbers.at_end(); ++more) {
      last[0] = last[1];
      last[1] = numbers.number();
    }
    builder_.add_vertex(xyz, line.number);
    if (!texture_) return;
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
  MeshBuilder builder_;
  Index vertices_ = 0, faces_ = 0;
  bool texture_ = false;
  std::vector<std::int32_t> corners_;
};

}  // namespace

SourceData read_off(const FileBytes& file, const ReadOptions&) {
  return OffReader(file).read();
}

}  // namespace knotfit
