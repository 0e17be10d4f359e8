// STL, text and binary: triangles alone, whose equal corners become one vertex.
#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstring>

#include "formats/binary_number.h"
#include "formats/mesh_builder.h"
#include "formats/number.h"
#include "formats/readers.h"
#include "formats/text_numbers.h"
#include "knotfit/errors.h"
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
  std::size_t slot_of(const double* place) const {
    std::size_t at = hash(place) & (slots_.size() - 1);
    while (slots_[at] >= 0 && std::memcmp(builder_.vertex(slots_[at]), place, 3 * sizeof(double)) != 0)
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
  const std::size_t count = claimed_triangles(bytes), left = bytes.size() - kHeader;
  if (count > left / kTriangle)
    throw FileError(file.path(),
                    fmt::format("the header claims {} triangles, which take {} bytes, but only {} bytes "
                                "follow it (room for {}); it is cut off, or no binary STL file",
                                count, count * kTriangle, left, left / kTriangle));
  if (count * kTriangle != left)
    throw FileError(file.path(),
                    fmt::format("the header claims {} triangles, which take {} bytes, but {} bytes "
                                "follow it; it is damaged, or no binary STL file",
                                count, count * kTriangle, left));
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
  return {file.path(), "stl", builder.finish()};
}

/// solid { facet normal .. outer loop vertex .. x 3 endloop endfacet } endsolid, one or more.
class TextReader {
 public:
  explicit TextReader(const FileBytes& file)
      : file_(file), text_(text_of(file)), lines_(text_), builder_(file, 0), welder_(builder_, 0) {}

  SourceData read() {
    bool open = false;
    while (next()) {
      if (word_ == "solid") {
        if (open) fail("a second solid before endsolid");
        open = true;
      } else if (word_ == "endsolid") {
        if (!open) fail("endsolid before solid");
        open = false;
      } else if (word_ == "facet") {
        if (!open) fail("a facet before solid");
        read_facet();
      } else {
        fail(fmt::format("{} where facet or endsolid is due", in_quotes(word_)));
      }
    }
    if (open) throw FileError(file_.path(), "the file ends before endsolid: it is cut off");
    return {file_.path(), "stl", builder_.finish()};
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw FileError(file_.path(), static_cast<long long>(line_.number), message);
  }
  /// The next line that is not blank, and its first word in lower case.
  bool next() {
    while (lines_.next(line_)) {
      if (line_.text.empty()) continue;
      const std::size_t end = std::min(line_.text.find_first_of(" \t"), line_.text.size());
      word_ = lower_case(line_.text.substr(0, std::min<std::size_t>(end, 64)));
      rest_ = line_.text.substr(end);
      return true;
    }
    return false;
  }
  void expect(const char* word) {
    if (!next())
      throw FileError(file_.path(), fmt::format("the file ends where {} is due: it is cut off", word));
    if (word_ != word) fail(fmt::format("{} where {} is due", in_quotes(word_), word));
  }
  void read_facet() {
    const Index line = line_.number;
    expect("outer");
    std::int32_t corners[3];
    for (std::int32_t& corner : corners) {
      expect("vertex");
      LineNumbers numbers(file_, line_, rest_, "vertex");
      double xyz[3];
      for (double& x : xyz) x = numbers.number();
      if (!numbers.at_end()) fail("the vertex has more than three numbers");
      corner = welder_.vertex(xyz, line_.number);
    }
    expect("endloop");
    expect("endfacet");
    builder_.add_face(corners, line, builder_.vertex_count());
  }

  const FileBytes& file_;
  std::string_view text_;
  LineReader lines_;
  TextLine line_;
  std::string word_;
  std::string_view rest_;
  MeshBuilder builder_;
  Welder welder_;
};

}  // namespace

SourceData read_stl(const FileBytes& file, const ReadOptions&) {
  const std::string_view bytes = file.view();
  // Binary files may begin with "solid" too: their size tells.
  const bool binary =
      bytes.size() >= kHeader && bytes.size() == kHeader + kTriangle * claimed_triangles(bytes);
  if (!binary && begins_with_solid(bytes) && bytes.find('\0') == std::string_view::npos)
    return TextReader(file).read();
  return read_binary(file);
}

}  // namespace knotfit
