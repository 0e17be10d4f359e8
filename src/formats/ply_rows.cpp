#include "formats/ply_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/missing.h"
#include "formats/number.h"
#include "formats/text_lines.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

std::string count_of(const PlyElement& e) {
  if (e.name == "vertex") return fmt::format("{} vertices", e.count);
  return fmt::format("{} {}s", e.count, e.name);
}

class BinaryRows : public PlyRows {
 public:
  BinaryRows(const FileBytes& file, const PlyHeader& header)
      : file_(file),
        big_endian_(header.encoding == PlyEncoding::big_endian),
        at_(file.view().data() + header.offset),
        end_(file.view().data() + file.size()) {}

  void begin_element(const PlyElement& element) override {
    element_ = &element;
    row_ = 0;
    const Index row = element.row_bytes(), left = end_ - at_;
    if (row == 0 || element.count <= left / row) return;
    std::string message = fmt::format("the header claims {} of {}{} bytes, but only {} bytes follow",
                                      count_of(element), element.has_list() ? "at least " : "", row, left);
    if (!element.has_list()) message += "; " + ending(left / row);
    throw FileError(file_.path(), message);
  }
  void begin_row(Index row) override { row_ = row; }
  double next(NumberType type) override {
    if (end_ - at_ < type.size) throw FileError(file_.path(), ending(row_));
    const double value = number_loader(type, big_endian_)(at_);
    at_ += type.size;
    return value;
  }
  Index next_count(const PlyProperty& list) override {
    const double count = next(list.count_type);
    if (count < 0)
      throw FileError(file_.path(), fmt::format("{} {} (counted from 0): a list of {} numbers",
                                                element_->name, row_, count));
    if (count * list.type.size > static_cast<double>(end_ - at_))
      throw FileError(file_.path(), fmt::format("{} (its list claims {} numbers)", ending(row_), count));
    return static_cast<Index>(count);
  }
  void skip(NumberType type, Index count) override {
    if (end_ - at_ < type.size * count) throw FileError(file_.path(), ending(row_));
    at_ += type.size * count;
  }
  Index triangles(const PlyElement& element, const PlyProperty& corners, Index most) const override {
    const char* at = at_;
    Index found = 0;
    for (Index row = 0; row < element.count; ++row)
      for (const PlyProperty& p : element.properties) {
        Index count = 1;
        if (p.list) {
          if (end_ - at < p.count_type.size) return found;
          const double claimed = number_loader(p.count_type, big_endian_)(at);
          at += p.count_type.size;
          if (!(claimed >= 0 && claimed * p.type.size <= static_cast<double>(end_ - at))) return found;
          count = static_cast<Index>(claimed);
        }
        if (end_ - at < count * p.type.size) return found;
        at += count * p.type.size;
        if (&p != &corners) continue;
        if (count > most) return found;
        found += std::max<Index>(count - 2, 0);
      }
    return found;
  }
  void end_row() override {}
  std::string end_file() override {
    // Some writers end binary data with a line end.
    while (at_ < end_ && (*at_ == '\n' || *at_ == '\r')) ++at_;
    if (at_ == end_) return "";
    return fmt::format("{} bytes follow the last {} that the header claims: left out", end_ - at_,
                       element_ != nullptr ? element_->name : "element");
  }
  Index line() const override { return 0; }

 private:
  std::string ending(Index row) const {
    return fmt::format("the file ends at byte {}, inside {} {} (counted from 0)", file_.size(),
                       element_->name, row);
  }
  const FileBytes& file_;
  bool big_endian_;
  const char* at_;
  const char* end_;
  const PlyElement* element_ = nullptr;
  Index row_ = 0;
};

class TextRows : public PlyRows {
 public:
  TextRows(const FileBytes& file, const PlyHeader& header)
      : file_(file), lines_(text_of(file).substr(header.offset)), header_lines_(header.lines) {}

  void begin_element(const PlyElement& element) override {
    element_ = &element;
    row_ = 0;
    // A number takes a digit and what parts it from the next.
    const double least = 2 * std::max<double>(1, static_cast<double>(element.properties.size()));
    if (static_cast<double>(element.count) * least > static_cast<double>(lines_.left()) + 1)
      throw FileError(
          file_.path(),
          fmt::format("the header claims {}, which take {:.0f} bytes at least, but only {} bytes follow",
                      count_of(element), static_cast<double>(element.count) * least, lines_.left()));
  }
  void begin_row(Index row) override {
    row_ = row;
    do
      if (!lines_.next(line_))
        throw FileError(file_.path(),
                        fmt::format("the file ends before {} {} (counted from 0) of the {} that the "
                                    "header claims",
                                    element_->name, row, element_->count));
    while (line_.text.empty());
    at_ = line_.text.data();
    end_ = at_ + line_.text.size();
  }
  double next(NumberType) override {
    at_ = skip_blanks(at_, end_);
    if (at_ == end_) fail("the line has too few numbers");
    double value = 0;
    const char* stop = parse_prefix(at_, end_, value);
    if (stop == at_ || (stop < end_ && !is_blank(*stop))) {
      stop = field_end(at_, end_, Separator::blanks);
      const std::string_view token(at_, static_cast<std::size_t>(stop - at_));
      ParsedNumber number = parse_number(token);
      if (number.status == NumberStatus::not_a_number && is_missing_word(token))
        number = {NumberStatus::ok, std::numeric_limits<double>::quiet_NaN()};
      if (number.status == NumberStatus::too_large)
        fail(in_quotes(token) + " is beyond the range of a double");
      if (number.status != NumberStatus::ok) fail(in_quotes(token) + " is not a number");
      value = number.value;
    }
    at_ = stop;
    return value;
  }
  Index next_count(const PlyProperty& list) override {
    const double count = next(list.count_type);
    if (!(count >= 0) || count != std::floor(count)) fail(fmt::format("a list of {} numbers", count));
    if (2 * count > static_cast<double>(end_ - at_) + 1) fail("the line has too few numbers");
    return static_cast<Index>(count);
  }
  void skip(NumberType type, Index count) override {
    static_cast<void>(type);
    for (Index k = 0; k < count; ++k) {
      at_ = skip_blanks(at_, end_);
      if (at_ == end_) fail("the line has too few numbers");
      at_ = field_end(at_, end_, Separator::blanks);  // whatever it is: it is left out
    }
  }
  Index triangles(const PlyElement& element, const PlyProperty&, Index) const override {
    return std::max<Index>(count_numbers(lines_.rest()) - 3 * element.count, 0);
  }
  void end_row() override {
    if (skip_blanks(at_, end_) != end_) fail("the line has more numbers than the header says");
  }
  std::string end_file() override {
    Index first = 0, count = 0;
    while (lines_.next(line_))
      if (!line_.text.empty() && count++ == 0) first = line();
    if (count == 0) return "";
    return fmt::format("{} after the last {} that the header claims, from line {}: left out",
                       count == 1 ? "a line" : fmt::format("{} lines", count),
                       element_ != nullptr ? element_->name : "element", first);
  }
  Index line() const override { return line_.number + header_lines_; }

 private:
  [[noreturn]] void fail(const std::string& message) const {
    throw FileError(file_.path(), static_cast<long long>(line()),
                    fmt::format("{} {} (counted from 0): {}", element_->name, row_, message));
  }
  const FileBytes& file_;
  LineReader lines_;
  Index header_lines_;
  TextLine line_;
  const char* at_ = nullptr;
  const char* end_ = nullptr;
  const PlyElement* element_ = nullptr;
  Index row_ = 0;
};

}  // namespace

std::unique_ptr<PlyRows> ply_rows(const FileBytes& file, const PlyHeader& header) {
  if (header.encoding == PlyEncoding::ascii) return std::make_unique<TextRows>(file, header);
  return std::make_unique<BinaryRows>(file, header);
}

}  // namespace knotfit
