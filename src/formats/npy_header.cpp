#include "formats/npy_header.h"

#include <fmt/format.h>

#include <bit>
#include <cctype>

#include "formats/number.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

/// Literals of the header's dictionary.
class Literals {
 public:
  Literals(const FileBytes& file, std::string_view text) : file_(file), text_(text) {}

  bool accept(char c) {
    skip_space();
    if (at_ >= text_.size() || text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!accept(c)) fail(fmt::format("'{}' is missing in the header", c));
  }
  bool sees(char c) {
    skip_space();
    return at_ < text_.size() && text_[at_] == c;
  }
  bool at_end() {
    skip_space();
    return at_ == text_.size();
  }
  std::string_view string() {
    skip_space();
    if (!sees('\'') && !sees('"')) fail("a string is missing in the header");
    const char quote = text_[at_];
    const std::size_t close = text_.find(quote, at_ + 1);
    if (close == std::string_view::npos) fail("a string of the header does not end");
    const std::string_view value = text_.substr(at_ + 1, close - at_ - 1);
    at_ = close + 1;
    return value;
  }
  bool boolean() {
    const std::string_view w = word();
    if (w != "True" && w != "False")
      fail(fmt::format("{} stands for a truth value in the header", in_quotes(w)));
    return w == "True";
  }
  std::vector<Index> shape() {
    std::vector<Index> out;
    expect('(');
    while (!accept(')')) {
      std::string_view w = word();
      if (w.ends_with('L')) w.remove_suffix(1);  // Python 2's long integers
      const Index n = parse_count(w);
      if (n < 0 || out.size() == 8)
        fail(fmt::format("the shape of the header cannot be read at {}", in_quotes(w)));
      out.push_back(n);
      if (!accept(',') && !sees(')')) fail("the shape of the header does not end");
    }
    return out;
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(file_.path(), "not a sound NPY file: " + what);
  }

 private:
  void skip_space() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n' || text_[at_] == '\t')) ++at_;
  }
  std::string_view word() {
    skip_space();
    const std::size_t begin = at_;
    while (at_ < text_.size() && std::isalnum(static_cast<unsigned char>(text_[at_]))) ++at_;
    return text_.substr(begin, at_ - begin);
  }

  const FileBytes& file_;
  std::string_view text_;
  std::size_t at_ = 0;
};

void take_type(const FileBytes& file, std::string_view type, NpyHeader& header) {
  const auto refuse = [&](std::string_view what) {
    throw FileError(file.path(),
                    fmt::format("holds {} (type {}); save the array as floating-point numbers, such "
                                "as with astype(float)",
                                what, in_quotes(type)));
  };
  std::string_view rest = type;
  char order = std::endian::native == std::endian::little ? '<' : '>';
  if (!rest.empty() && std::string_view("<>|=").find(rest.front()) != std::string_view::npos) {
    if (rest.front() == '<' || rest.front() == '>') order = rest.front();
    rest.remove_prefix(1);
  }
  if (rest.starts_with('O')) refuse("Python objects, which are never unpickled");
  if (rest.starts_with('c')) refuse("complex numbers");
  if (rest.starts_with('b')) refuse("truth values");
  if (rest.size() < 2 || (rest[0] != 'f' && rest[0] != 'i' && rest[0] != 'u')) refuse("no real numbers");
  const Index bytes = parse_count(rest.substr(1));
  const bool known = bytes == 2 || bytes == 4 || bytes == 8 || (bytes == 1 && rest[0] != 'f');
  if (!known) refuse("numbers of a size that this program does not read");
  header.kind = rest[0];
  header.item_size = static_cast<int>(bytes);
  header.big_endian = order == '>';
}

std::string_view dictionary(const FileBytes& file, std::size_t& offset) {
  const std::string_view bytes = file.view();
  if (!bytes.starts_with(kNpyMagic))
    throw FileError(file.path(), "is not an NPY file (it does not begin with \\x93NUMPY)");
  const auto byte = [&](std::size_t i) {
    return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i]));
  };
  if (bytes.size() < 12) throw FileError(file.path(), "the file ends inside the NPY header");
  const std::size_t version = byte(6);
  if (version < 1 || version > 3)
    throw FileError(file.path(),
                    fmt::format("NPY version {}.{} is unknown (1 to 3 are read)", version, byte(7)));
  offset = version == 1 ? 10 : 12;
  const std::size_t length = version == 1 ? byte(8) + (byte(9) << 8)
                                          : byte(8) + (byte(9) << 8) + (byte(10) << 16) + (byte(11) << 24);
  if (length > bytes.size() - offset)
    throw FileError(file.path(),
                    fmt::format("the file ends inside the NPY header, which claims {} bytes", length));
  const std::string_view text = bytes.substr(offset, length);
  offset += length;
  return text;
}

/// The product of the shape against the bytes that follow.
void check_size(const FileBytes& file, const NpyHeader& header) {
  const std::size_t follow = file.size() - header.offset;
  const std::size_t most = follow / static_cast<std::size_t>(header.item_size);
  std::size_t count = 1;
  bool empty = false;
  for (const Index n : header.shape) empty = empty || n == 0;
  if (empty || header.shape.empty())
    throw FileError(file.path(),
                    fmt::format("an array of shape {} holds no points", shape_text(header.shape)));
  for (const Index n : header.shape) {
    if (static_cast<std::size_t>(n) > most / count)
      throw FileError(file.path(),
                      fmt::format("the header claims {} numbers of {} bytes, but only {} bytes follow",
                                  shape_text(header.shape), header.item_size, follow));
    count *= static_cast<std::size_t>(n);
  }
  if (count * static_cast<std::size_t>(header.item_size) != follow)
    throw FileError(file.path(), fmt::format("{} numbers of {} bytes make {} bytes, but {} follow the header",
                                             shape_text(header.shape), header.item_size,
                                             count * static_cast<std::size_t>(header.item_size), follow));
}

}  // namespace

std::string shape_text(const std::vector<Index>& shape) {
  return shape.empty() ? "()" : fmt::format("{}", fmt::join(shape, " x "));
}

NpyHeader parse_npy_header(const FileBytes& file) {
  NpyHeader header;
  Literals in(file, dictionary(file, header.offset));
  bool has_type = false, has_order = false, has_shape = false;
  in.expect('{');
  while (!in.accept('}')) {
    const std::string_view key = in.string();
    in.expect(':');
    if (key == "descr" && !has_type) {
      if (in.sees('['))
        throw FileError(file.path(),
                        "holds a structured array; save its columns as one n x k array of numbers");
      take_type(file, in.string(), header);
      has_type = true;
    } else if (key == "fortran_order" && !has_order) {
      header.fortran_order = in.boolean();
      has_order = true;
    } else if (key == "shape" && !has_shape) {
      header.shape = in.shape();
      has_shape = true;
    } else {
      in.fail(fmt::format("unexpected key {} in the header", in_quotes(key)));
    }
    if (!in.accept(',') && !in.sees('}')) in.fail("the header's dictionary does not end");
  }
  if (!in.at_end()) in.fail("something follows the header's dictionary");
  if (!has_type || !has_order || !has_shape) in.fail("the header lacks descr, fortran_order or shape");
  check_size(file, header);
  return header;
}

}  // namespace knotfit
