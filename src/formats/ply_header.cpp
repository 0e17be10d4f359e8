#include "formats/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "formats/mesh_builder.h"
#include "formats/number.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr std::pair<std::string_view, NumberType> kTypes[] = {
    {"char", {'i', 1}},  {"uchar", {'u', 1}},  {"short", {'i', 2}},   {"ushort", {'u', 2}},
    {"int", {'i', 4}},   {"uint", {'u', 4}},   {"float", {'f', 4}},   {"double", {'f', 8}},
    {"int8", {'i', 1}},  {"uint8", {'u', 1}},  {"int16", {'i', 2}},   {"uint16", {'u', 2}},
    {"int32", {'i', 4}}, {"uint32", {'u', 4}}, {"float32", {'f', 4}}, {"float64", {'f', 8}},
    {"int64", {'i', 8}}, {"uint64", {'u', 8}}};

class HeaderParser {
 public:
  explicit HeaderParser(const FileBytes& file) : file_(file), rest_(file.view()) {
    const std::string_view bytes = file.view();
    if (!bytes.starts_with("ply") || bytes.size() < 4 ||
        (bytes[3] != '\n' && bytes[3] != '\r' && bytes[3] != ' ')) {
      const std::string kind = foreign_kind(bytes);
      throw FileError(file.path(), fmt::format("is not a PLY file: it does not begin with a line \"ply\"{}",
                                               kind.empty() ? "" : " but like " + kind));
    }
    const std::size_t end = bytes.find_first_of("\r\n");
    if (end != std::string_view::npos && bytes[end] == '\r' && bytes.substr(end + 1, 1) != "\n") end_ = '\r';
  }

  PlyHeader parse() {
    std::string_view line;
    next(line);
    bool format = false;
    for (;;) {
      next(line);
      const auto words = split_fields(line, Separator::blanks);
      if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
      if (words[0] == "end_header") break;
      if (words[0] == "format") {
        take_format(words);
        format = true;
      } else if (words[0] == "element") {
        take_element(words);
      } else if (words[0] == "property") {
        take_property(words);
      } else {
        fail(fmt::format("{} is no word of a PLY header", in_quotes(words[0])));
      }
    }
    if (!format) fail("the header has no format line");
    header_.offset = file_.size() - rest_.size();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw FileError(file_.path(), static_cast<long long>(header_.lines), message);
  }

  void next(std::string_view& line) {
    if (rest_.empty()) throw FileError(file_.path(), "the header has no end_header line");
    const std::size_t end = rest_.find(end_);
    line = trimmed(rest_.substr(0, end));
    rest_ = end == std::string_view::npos ? std::string_view() : rest_.substr(end + 1);
    ++header_.lines;
  }

  void take_format(const std::vector<std::string_view>& words) {
    if (words.size() < 2) fail("format needs a name and a version");
    if (words[1] == "ascii")
      header_.encoding = PlyEncoding::ascii;
    else if (words[1] == "binary_little_endian")
      header_.encoding = PlyEncoding::little_endian;
    else if (words[1] == "binary_big_endian")
      header_.encoding = PlyEncoding::big_endian;
    else
      fail(fmt::format("format {} is none of ascii, binary_little_endian, binary_big_endian",
                       in_quotes(words[1])));
    if (words.size() > 2 && words[2] != "1.0")
      fail(fmt::format("version {} of PLY is not known; 1.0 is", in_quotes(words[2])));
  }

  void take_element(const std::vector<std::string_view>& words) {
    if (words.size() != 3) fail("element needs a name and a count");
    const Index count = parse_count(words[2]);
    if (count < 0)
      fail(fmt::format("the count of element {} is {}", in_quotes(words[1]), in_quotes(words[2])));
    for (const PlyElement& e : header_.elements)
      if (e.name == words[1]) fail(fmt::format("a second element {}", in_quotes(words[1])));
    header_.elements.push_back({std::string(words[1]), count, {}});
  }

  NumberType type_of(std::string_view word) const {
    for (const auto& [name, type] : kTypes)
      if (name == word) return type;
    fail(fmt::format("{} is no type of a property", in_quotes(word)));
  }

  void take_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) fail("a property before the first element");
    PlyProperty p;
    p.list = words.size() > 1 && words[1] == "list";
    if (words.size() != (p.list ? 5U : 3U))
      fail("property needs a type and a name, or list, two types and a name");
    if (p.list) p.count_type = type_of(words[2]);
    p.type = type_of(words[words.size() - 2]);
    p.name = words.back();
    if (p.list && p.count_type.kind == 'f')
      fail(fmt::format("the count of list {} is no integer", in_quotes(p.name)));
    header_.elements.back().properties.push_back(std::move(p));
  }

  const FileBytes& file_;
  std::string_view rest_;
  char end_ = '\n';
  PlyHeader header_;
};

}  // namespace

Index PlyElement::row_bytes() const {
  Index bytes = 0;
  for (const PlyProperty& p : properties) bytes += p.list ? p.count_type.size : p.type.size;
  return bytes;
}

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty& p) { return p.list; });
}

PlyHeader parse_ply_header(const FileBytes& file) {
  return HeaderParser(file).parse();
}

}  // namespace knotfit
