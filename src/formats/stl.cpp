// STL, text and binary: triangles alone, whose equal corners become one vertex.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "formats/binary_number.h"
#include "formats/mesh_builder.h"
#include "formats/number.h"
#include "formats/readers.h"
#include "formats/text_numbers.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr std::size_t kHeader = 84;  // 80 bytes of anything and the count
constexpr std::size_t kTriangle = 50;

/// One vertex a place: corners equal bit for bit, 0 and -0 too, are the same.
class Welder {
 public:
  Welder(MeshBuilder& builder, Index triangles) : builder_(builder) {
    // Half as many vertices as triangles in most meshes; grown where there are more.
    slots_.assign(std::bit_ceil(static_cast<std::size_t>(triangles) + 16), -1);
  }
  std::int32_t vertex(const double* xyz, Index line) {
    const double place[3] = {xyz[0] + 0.0, xyz[1] + 0.0, xyz[2] + 0.0};  // -0 + 0 is 0
    std::size_t at = slot_of(place);
    if (slots_[at] >= 0) return slots_[at];
    if (2 * static_cast<std::size_t>(builder_.vertex_count() + 1) > slots_.size()) {
      grow();
      at = slot_of(place);
    }
    const auto added = static_cast<std::int32_t>(builder_.vertex_count());
    builder_.add_vertex(place, line);
    slots_[at] = added;
    return added;
  }

 private:
  static std::size_t hash(const double* place) {
    std::uint64_t h = 0;
    for (int d = 0; d < 3; ++d) {
      // splitmix64 [Steele14]
      h += std::bit_cast<std::uint64_t>(place[d]) + 0x9e3779b97f4a7c15U;
      h = (h ^ h >> 30) * 0xbf58476d1ce4e5b9U;
      h = (h ^ h >> 27) * 0x94d049bb133111ebU;
      h ^= h >> 31;
    }
    return static_cast<std::size_t>(h);
  }
  static bool same_bits(const double* a, const double* b) {
    const auto bits = [](double x) { return std::bit_cast<std::uint64_t>(x); };
    return std::equal(a, a + 3, b, [&](double x, double y) { return bits(x) == bits(y); });
  }
  std::size_t slot_of(const double* place) const {
    std::size_t at = hash(place) & (slots_.size() - 1);
    while (slots_[at] >= 0 && !same_bits(place, builder_.vertex(slots_[at])))
      at = (at + 1) & (slots_.size() - 1);
    return at;
  }
  void grow() {
    slots_.assign(2 * slots_.size(), -1);
    for (Index k = 0; k < builder_.vertex_count(); ++k)
      slots_[slot_of(builder_.vertex(k))] = static_cast<std::int32_t>(k);
  }
  MeshBuilder& builder_;
  std::vector<std::int32_t> slots_;
};

bool begins_with_solid(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  const std::size_t at = bytes.find_first_not_of(" \t\r\n");
  return at != std::string_view::npos && lower_case(bytes.substr(at, 5)) == "solid";
}

std::size_t claimed_triangles(std::string_view bytes) {
  return static_cast<std::size_t>(number_loader({'u', 4}, false)(bytes.data() + 80));
}

SourceData read_binary(const FileBytes& file) {
  const std::string_view bytes = file.view();
  const std::string kind = foreign_kind(bytes);
  if (bytes.size() < kHeader || !kind.empty())
    throw FileError(file.path(), fmt::format("is not an STL file: {}",
                                             !kind.empty() ? "it begins like " + kind
                                                           : fmt::format("it has {} bytes, and neither "
                                                                         "\"solid\" at its beginning nor "
                                                                         "a header of {}",
                                                                         bytes.size(), kHeader)));
  std::size_t count = claimed_triangles(bytes);
  const std::size_t left = bytes.size() - kHeader;
  if (count > left / kTriangle)
    throw FileError(file.path(),
                    fmt::format("the header claims {} triangles, which take {} bytes, but only {} bytes "
                                "follow it (room for {}); it is cut off, or no binary STL file",
                                count, count * kTriangle, left, left / kTriangle));
  std::vector<std::string> notes;
  if (count == 0 && left > 0 && left % kTriangle == 0) {
    // A count that was never filled in.
    count = left / kTriangle;
    notes.push_back(fmt::format("the header claims 0 triangles, but the bytes of {} follow it: read", count));
  } else if (count > 0 && count * kTriangle < left) {
    const std::size_t more = left - count * kTriangle;
    notes.push_back(
        fmt::format("{} bytes follow the last of the {} triangles that the header claims{}: left out", more,
                    count, more % kTriangle == 0 ? fmt::format(", room for {} more", more / kTriangle) : ""));
  }
  if (count == 0) throw FileError(file.path(), "the header claims 0 triangles");
  MeshBuilder builder(file, 0);
  const auto triangles = static_cast<Index>(count);
  check_claim(file, triangles, "triangles", 0, 0);
  builder.reserve(triangles / 2 + 2, triangles, false);
  Welder welder(builder, triangles);
  const LoadNumber load = number_loader({'f', 4}, false);
  for (Index t = 0; t < triangles; ++t) {
    const char* at =
        bytes.data() + kHeader + static_cast<std::size_t>(t) * kTriangle + 12;  // after the normal
    std::int32_t corners[3];
    for (std::int32_t& corner : corners) {
      double xyz[3];
      for (double& x : xyz) {
        x = load(at);
        at += 4;
        if (!std::isfinite(x))
          throw FileError(file.path(),
                          fmt::format("triangle {} (counted from 0): a coordinate is not finite", t));
      }
      corner = welder.vertex(xyz, 0);
    }
    builder.add_face(corners, 0, builder.vertex_count());
  }
  return {.path = file.path(), .format = "stl", .content = builder.finish(), .notes = std::move(notes)};
}

/// Words of a text parted by blanks and line ends, without comments.
class Words {
 public:
  explicit Words(std::string_view all) : at_(all.data()), end_(all.data() + all.size()) {}
  Index line() const { return line_; }
  /// The next word, in `word` in lower case too. \return false at the end
  bool next() {
    for (;;) {
      while (at_ < end_ && (is_blank(*at_) || *at_ == '\n')) step();
      if (at_ == end_) return false;
      if (*at_ != '#' && *at_ != ';' && !std::string_view(at_, left()).starts_with("//")) break;
      skip_line();
    }
    const char* const begin = at_;
    while (at_ < end_ && !is_blank(*at_) && *at_ != '\n') ++at_;
    text = {begin, static_cast<std::size_t>(at_ - begin)};
    word = lower_case(text.substr(0, 64));
    return true;
  }
  void skip_line() { at_ += std::min(rest_of_line().size(), left()); }
  /// After a solid's name, which may be any words: the end of the line, or a facet that begins in it.
  void skip_name() {
    const std::string rest = lower_case(rest_of_line());
    for (std::size_t at = rest.find("facet"); at != std::string::npos; at = rest.find("facet", at + 1)) {
      if (at == 0 || !is_blank(rest[at - 1])) continue;
      const std::size_t after = std::min(rest.find_first_not_of(" \t", at + 5), rest.size());
      if (after == at + 5 ||
          !(rest.substr(after).starts_with("normal") || rest.substr(after).starts_with("outer")))
        continue;
      at_ += at;
      return;
    }
    skip_line();
  }

  std::string_view text;
  std::string word;

 private:
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }
  std::string_view rest_of_line() const {
    const std::string_view rest(at_, left());
    return rest.substr(0, rest.find_first_of("\n\r"));
  }
  void step() {
    // CR LF is one line end, and so is CR alone.
    line_ += *at_ == '\n' || (*at_ == '\r' && (at_ + 1 == end_ || at_[1] != '\n'));
    ++at_;
  }
  const char* at_;
  const char* end_;
  Index line_ = 1;
};

/// solid { facet normal .. outer loop vertex .. x 3 endloop endfacet } endsolid, one or more, on as many lines as the
/// writer liked; "end loop" is endloop. What else stands between, such as colours, is left out.
class TextReader {
 public:
  explicit TextReader(const FileBytes& file)
      : file_(file), words_(text_of(file)), builder_(file, 0), welder_(builder_, 0) {}

  SourceData read() {
    bool open = false, solids = false;
    while (next()) {
      if (word_ == "solid") {
        if (open) fail("a second solid before endsolid");
        open = solids = true;
        words_.skip_name();
      } else if (word_ == "endsolid") {
        if (!open) fail("endsolid before solid");
        open = false;
        words_.skip_name();
      } else if (word_ == "facet") {
        if (solids && !open) fail("a facet before solid");
        read_facet();
      } else if (is_structure(word_)) {
        fail(fmt::format("{} where facet or endsolid is due", in_quotes(text_)));
      } else {
        leave_out();
        words_.skip_line();
      }
    }
    if (open) throw FileError(file_.path(), "the file ends before endsolid: it is cut off");
    std::vector<std::string> notes;
    if (left_out_ > 0)
      notes.push_back(fmt::format("line {}: {} is no word of an STL file: left out{}", left_out_line_,
                                  in_quotes(left_out_word_),
                                  left_out_ == 1 ? "" : fmt::format(", like {} more", left_out_ - 1)));
    return {.path = file_.path(), .format = "stl", .content = builder_.finish(), .notes = std::move(notes)};
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw FileError(file_.path(), static_cast<long long>(line_), message);
  }
  static bool is_structure(const std::string& word) {
    for (const char* known :
         {"solid", "endsolid", "facet", "endfacet", "outer", "outerloop", "loop", "endloop", "vertex"})
      if (word == known) return true;
    return false;
  }
  static bool is_number(std::string_view text) {
    return parse_number(text).status != NumberStatus::not_a_number;
  }
  /// The next word, "end loop" as one.
  bool next() {
    if (!words_.next()) return false;
    line_ = words_.line();
    word_ = words_.word;
    text_ = words_.text;
    if (word_ != "end") return true;
    const Words before = words_;
    if (words_.next() && (words_.word == "solid" || words_.word == "facet" || words_.word == "loop"))
      word_ += words_.word;
    else
      words_ = before;
    return true;
  }
  void leave_out() {
    if (left_out_++ > 0) return;
    left_out_line_ = line_;
    left_out_word_ = text_;
  }
  /// The next word of the structure: numbers before it, such as a normal or a colour, are left out.
  void next_structure(const char* due) {
    for (;;) {
      if (!next())
        throw FileError(file_.path(), fmt::format("the file ends where {} is due: it is cut off", due));
      if (is_structure(word_)) return;
      if (word_ != "normal" && !is_number(text_)) leave_out();
    }
  }
  void expect(const char* word) {
    next_structure(word);
    if (word_ != word) fail(fmt::format("{} where {} is due", in_quotes(text_), word));
  }
  double coordinate() {
    const Index line = line_;
    if (!words_.next()) throw FileError(file_.path(), "the file ends inside a vertex: it is cut off");
    line_ = words_.line();
    if (is_structure(words_.word) && line_ != line) {
      line_ = line;
      fail("the vertex has too few numbers");
    }
    return LineNumbers(file_, {words_.text, line_}, words_.text, "vertex").number();
  }
  void read_facet() {
    const Index line = line_;
    next_structure("outer");
    if (word_ != "outer" && word_ != "outerloop")
      fail(fmt::format("{} where outer is due", in_quotes(text_)));
    corners_.clear();
    for (;;) {
      next_structure(corners_.size() < 3 ? "vertex" : "endloop");
      if (word_ == "loop" && corners_.empty()) continue;
      if (word_ == "endloop" && corners_.size() >= 3) break;
      if (word_ != "vertex")
        fail(fmt::format("{} where {} is due", in_quotes(text_), corners_.size() < 3 ? "vertex" : "endloop"));
      const Index at = line_;
      double xyz[3];
      for (double& x : xyz) x = coordinate();
      corners_.push_back(welder_.vertex(xyz, at));
    }
    expect("endfacet");
    builder_.add_face(corners_, line, builder_.vertex_count());
  }

  const FileBytes& file_;
  Words words_;
  std::string word_;       // in lower case
  std::string_view text_;  // as it stands
  Index line_ = 0;
  MeshBuilder builder_;
  Welder welder_;
  std::vector<std::int32_t> corners_;
  Index left_out_ = 0, left_out_line_ = 0;
  std::string left_out_word_;
};

/// Text says "solid" first, but so do headers of binary files: their bytes hold zeros, text none but at its end.
bool is_text(std::string_view bytes) {
  if (bytes.size() >= kHeader && bytes.size() == kHeader + kTriangle * claimed_triangles(bytes)) return false;
  bytes = bytes.substr(0, bytes.find_last_not_of('\0') + 1);
  if (begins_with_solid(bytes) && bytes.find('\0') == std::string_view::npos) return true;
  const std::string head = lower_case(bytes.substr(0, 4096));
  return head.find('\0') == std::string::npos && head.find("facet") != std::string::npos &&
         head.find("vertex") != std::string::npos;
}

}  // namespace

SourceData read_stl(const FileBytes& file, const ReadOptions&) {
  return is_text(file.view()) ? TextReader(file).read() : read_binary(file);
}

}  // namespace knotfit
