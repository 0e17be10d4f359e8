#include "formats/pcd_header.h"

#include <fmt/format.h>

#include <algorithm>

#include "formats/mesh_builder.h"
#include "formats/number.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

constexpr Index kMostFields = 1000, kMostCount = 100000;  // numbers of a field: descriptors have hundreds
constexpr Index kMostPoints = Index{1} << 40;

class HeaderParser {
 public:
  explicit HeaderParser(const FileBytes& file) : file_(file), rest_(file.view()) {
    if (const std::string kind = foreign_kind(rest_); !kind.empty())
      throw FileError(file.path(), "is not a PCD file: it begins like " + kind);
  }

  PcdHeader parse() {
    while (next()) {
      if (words_.empty() || words_[0].starts_with('#')) continue;
      if (words_[0] == "DATA") {
        take_encoding();
        header_.offset = file_.size() - rest_.size();
        check_whole();
        return std::move(header_);
      }
      take_line();
    }
    throw FileError(file_.path(), header_.lines > 0 && !header_.fields.empty()
                                      ? "the file ends inside its PCD header, before DATA: it is cut off"
                                      : "is not a PCD file: it has no lines FIELDS and DATA");
  }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw FileError(file_.path(), static_cast<long long>(header_.lines), message);
  }

  bool next() {
    constexpr std::size_t longest = 1 << 16;
    if (rest_.empty()) return false;
    const std::size_t end = rest_.substr(0, longest).find('\n');
    if (end == std::string_view::npos && rest_.size() > longest)
      throw FileError(file_.path(), "is not a PCD file: its header has a line without an end");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++header_.lines;
    words_ = split_fields(trimmed(line), Separator::blanks);
    return true;
  }

  Index count(std::string_view word, Index least, Index most) const {
    const Index n = parse_count(word);
    if (n < least || n > most)
      fail(fmt::format("{}: {} is no number from {} to {}", words_[0], in_quotes(word), least, most));
    return n;
  }

  void take_line() {
    const std::string_view word = words_[0];
    if (word == "VERSION" || word == "VIEWPOINT") return;
    if (word == "FIELDS" || word == "COLUMNS") return take_fields();
    if (word == "SIZE" || word == "TYPE" || word == "COUNT") return take_of_fields();
    if (word != "WIDTH" && word != "HEIGHT" && word != "POINTS")
      fail(fmt::format("{} is no word of a PCD header", in_quotes(word)));
    if (words_.size() != 2) fail(fmt::format("{} wants one number", word));
    const Index n = count(words_[1], 0, kMostPoints);
    if (word == "POINTS") points_given_ = true;
    (word == "WIDTH" ? header_.width : word == "HEIGHT" ? header_.height : header_.points) = n;
  }

  void take_fields() {
    if (!header_.fields.empty()) fail("a second list of fields");
    if (words_.size() < 2 || static_cast<Index>(words_.size()) > kMostFields)
      fail(fmt::format("{} fields; there are 1 to {}", words_.size() - 1, kMostFields));
    for (std::size_t k = 1; k < words_.size(); ++k) header_.fields.push_back({std::string(words_[k])});
  }

  void take_of_fields() {
    if (words_.size() != header_.fields.size() + 1)
      fail(fmt::format("{} has {} values, but there are {} fields", words_[0], words_.size() - 1,
                       header_.fields.size()));
    for (std::size_t k = 1; k < words_.size(); ++k) {
      PcdField& field = header_.fields[k - 1];
      if (words_[0] == "COUNT") {
        field.count = count(words_[k], 0, kMostCount);
        if (field.count == 0) field.count = 1;  // as PCL reads it
      } else if (words_[0] == "SIZE") {
        field.type.size = static_cast<int>(count(words_[k], 1, 8));
      } else {
        const std::string type = lower_case(words_[k].substr(0, 2));
        if (type != "f" && type != "i" && type != "u")
          fail(fmt::format("TYPE {}: there are F, I and U", in_quotes(words_[k])));
        field.type.kind = type[0];
      }
    }
  }

  void take_encoding() {
    const std::string_view name = words_.size() == 2 ? words_[1] : std::string_view();
    if (name == "ascii")
      header_.encoding = PcdEncoding::ascii;
    else if (name == "binary")
      header_.encoding = PcdEncoding::binary;
    else if (name == "binary_compressed")
      header_.encoding = PcdEncoding::compressed;
    else
      fail(fmt::format("DATA {}: there are ascii, binary and binary_compressed", in_quotes(name)));
  }

  void check_whole() {
    if (header_.fields.empty()) fail("the header names no FIELDS");
    for (const PcdField& f : header_.fields) {
      const int size = f.type.size;
      if ((size != 1 && size != 2 && size != 4 && size != 8) || (f.type.kind == 'f' && size < 4))
        fail(fmt::format("field {}: there are no numbers of type {} and {} bytes", in_quotes(f.name),
                         static_cast<char>(f.type.kind - 'a' + 'A'), size));
    }
    const double cells = static_cast<double>(header_.width) * static_cast<double>(header_.height);
    if (!points_given_ && cells <= static_cast<double>(kMostPoints))
      header_.points = header_.width * header_.height;
    if (header_.width == 0 && points_given_)
      header_.width = header_.points, header_.height = 1;
    else if (static_cast<double>(header_.points) != cells)
      fail(fmt::format("POINTS is {}, but WIDTH x HEIGHT are {} x {}", header_.points, header_.width,
                       header_.height));
    if (header_.points == 0) fail("the header claims 0 points");
  }

  const FileBytes& file_;
  std::string_view rest_;
  PcdHeader header_;
  bool points_given_ = false;
  std::vector<std::string_view> words_;
};

}  // namespace

PcdHeader parse_pcd_header(const FileBytes& file) {
  return HeaderParser(file).parse();
}

}  // namespace knotfit
