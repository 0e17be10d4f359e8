#include "formats/cad/step_syntax.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "formats/number.h"
#include "knotfit/exceptions.h"
#include "knotfit/index.h"
namespace knotfit::cad {
namespace {

constexpr std::string_view kFirst = "ISO-10303-21;", kLast = "END-ISO-10303-21;";
constexpr int kDeepest = 100;
constexpr double kLargest = 1e30;  ///< of any number: what squares and products of it may still hold

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_word(char c) {
  return is_digit(c) || c == '_' || (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
}

/// Types of geometry and topology: their lists hold something [ISO 10303-42], and OpenCASCADE crashes on those that do
/// not.
bool has_full_lists(std::string_view type) {
  constexpr std::string_view words[] = {"BREP",          "CURVE",  "DIRECTION", "FACE",
                                        "GEOMETRIC_SET", "LOOP",   "POINT",     "POLY",
                                        "SHELL",         "SPLINE", "SURFACE",   "TRANSFORM"};
  return std::any_of(std::begin(words), std::end(words),
                     [&](std::string_view word) { return type.find(word) != std::string_view::npos; });
}

struct Place {
  Index id = 0;
  long long line = 0;
  bool operator<(const Place& other) const { return id < other.id; }
};
/// Entity number `from` of those defined names entity `id`.
struct Reference : Place {
  std::size_t from = 0;
};

class Scanner {
 public:
  Scanner(std::string_view text, const std::string& path)
      : p_(text.data()), end_(text.data() + text.size()), path_(path) {}

  void run() {
    while (pass_blanks()) {
      const std::string_view word = keyword();
      if (word == "DATA") {
        pass_statement();
        data_section();
      } else {
        pass_statement();
      }
    }
    check_references();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw FileError(path_, line_, what); }

  /// Blanks and comments. \return whether something follows
  bool pass_blanks() {
    while (p_ < end_) {
      if (*p_ == '\n') {
        ++line_;
      } else if (*p_ == '/' && end_ - p_ > 1 && p_[1] == '*') {
        const std::size_t close = std::string_view(p_ + 2, end_).find("*/");
        if (close == std::string_view::npos) fail("a comment has no end");
        line_ += std::count(p_, p_ + 2 + close, '\n');
        p_ += close + 3;
      } else if (*p_ != ' ' && *p_ != '\t' && *p_ != '\r' && *p_ != '\f') {
        return true;
      }
      ++p_;
    }
    return false;
  }
  std::string_view keyword() {
    const char* const begin = p_;
    if (p_ < end_ && *p_ == '!') ++p_;  // of the user's own
    while (p_ < end_ && (is_word(*p_) || *p_ == '-')) ++p_;
    return {begin, p_};
  }
  void pass_string() {
    const long long begin = line_;
    do {  // a quote inside is doubled
      for (++p_; p_ < end_ && *p_ != '\''; ++p_)
        if (*p_ == '\n') ++line_;
      if (p_ == end_) throw FileError(path_, begin, "a string has no end");
      ++p_;
    } while (p_ < end_ && *p_ == '\'');
  }
  /// To the semicolon, whatever stands before.
  void pass_statement() {
    while (pass_blanks()) {
      if (*p_ == '\'') {
        pass_string();
      } else if (*p_++ == ';') {
        return;
      }
    }
    fail("a statement has no end");
  }

  Index reference() {
    const char* const begin = ++p_;
    while (p_ < end_ && is_digit(*p_)) ++p_;
    const Index id = parse_count({begin, p_});
    if (id < 0) fail("# without a number");
    return id;
  }
  void pass_number() {
    const char* const begin = p_;
    while (p_ < end_ && (is_word(*p_) || *p_ == '.' || *p_ == '+' || *p_ == '-')) ++p_;
    const std::string_view token(begin, p_);
    const ParsedNumber number = parse_number(token);
    if (number.status == NumberStatus::not_a_number) fail(in_quotes(token) + " is no number");
    if (number.status == NumberStatus::too_large || !(std::abs(number.value) <= kLargest))
      fail(in_quotes(token) + " is larger than any length or count may be");
  }
  void expect(char c, const char* otherwise) {
    if (!pass_blanks() || *p_ != c) fail(otherwise);
    ++p_;
  }
  /// One value of a list: nothing may be left out, since OpenCASCADE crashes on what is.
  void value(int depth) {
    if (!pass_blanks()) fail("a list has no end");
    const char c = *p_;
    if (c == '\'') {
      pass_string();
    } else if (c == '#') {
      const long long line = line_;
      const Index id = reference();
      used_.push_back({{id, line}, defined_.size() - 1});
    } else if (is_digit(c) || c == '-' || c == '+') {
      pass_number();
    } else if (c == '$' || c == '*') {
      ++p_;
    } else if (c == '.') {  // of an enumeration
      ++p_;
      if (keyword().empty() || p_ == end_ || *p_ != '.') fail("a word between points is missing");
      ++p_;
    } else if (c == '"') {  // binary
      do ++p_;
      while (p_ < end_ && *p_ != '"');
      if (p_ == end_) fail("a binary value has no end");
      ++p_;
    } else if (c == '(' || !keyword().empty()) {  // a list, of a named type or not
      list(depth + 1);
    } else {
      fail(in_quotes({p_, 1}) + " in place of a value");
    }
  }
  void list(int depth) {
    if (depth > kDeepest) fail("lists are nested too deep");
    expect('(', "( is missing");
    if (pass_blanks() && *p_ == ')') {
      if (depth > 0 && has_full_lists(type_)) fail(fmt::format("a list of {} is empty", type_));
      ++p_;
      return;
    }
    for (;;) {
      value(depth);
      if (!pass_blanks() || (*p_ != ',' && *p_ != ')')) fail("',' or ')' is missing in a list");
      if (*p_++ == ')') return;
    }
  }
  void simple_entity() {
    type_ = keyword();
    if (type_.empty()) fail("an entity has no type");
    list(0);
  }
  /// TYPE(...), or (TYPE(...) TYPE(...)) of an entity of several types.
  void entity() {
    if (!pass_blanks()) fail("an entity has no type");
    if (*p_ != '(') return simple_entity();
    ++p_;
    while (pass_blanks() && *p_ != ')') simple_entity();
    expect(')', "an entity has no end");
  }
  void data_section() {
    while (pass_blanks()) {
      if (*p_ != '#') {
        const std::string_view word = keyword();
        if (word != "ENDSEC") fail("an entity begins with # and its number");
        pass_statement();
        return;
      }
      const long long line = line_;
      defined_.push_back({reference(), line});
      expect('=', "= is missing behind an entity's number");
      entity();
      expect(';', "; is missing behind an entity");
    }
    fail("the DATA section has no end");
  }
  void check_references() const {
    std::vector<std::size_t> order(defined_.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(),
              [&](std::size_t a, std::size_t b) { return defined_[a].id < defined_[b].id; });
    for (std::size_t k = 1; k < order.size(); ++k) {
      const Place &a = defined_[order[k - 1]], &b = defined_[order[k]];
      if (a.id == b.id)
        throw FileError(path_, std::max(a.line, b.line), fmt::format("entity #{} is there twice", a.id));
    }
    std::vector<std::size_t> to;  // of each reference, the number of the entity it names
    for (const Reference& use : used_) {
      const auto found = std::lower_bound(order.begin(), order.end(), use.id,
                                          [&](std::size_t k, Index id) { return defined_[k].id < id; });
      if (found == order.end() || defined_[*found].id != use.id)
        throw FileError(path_, use.line, fmt::format("entity #{} is not there", use.id));
      to.push_back(*found);
    }
    check_no_cycle(to);
  }
  /// Entities that lead back to themselves keep OpenCASCADE going round until its stack is full. References come in
  /// the order of the entities that they are of.
  void check_no_cycle(const std::vector<std::size_t>& to) const {
    std::vector<std::size_t> begin(defined_.size() + 1, 0);
    for (const Reference& use : used_) ++begin[use.from + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    enum class State : char { fresh, open, done };
    std::vector<State> state(defined_.size(), State::fresh);
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1), way;
    for (std::size_t root = 0; root < defined_.size(); ++root) {
      if (state[root] != State::fresh) continue;
      way.push_back(root);
      state[root] = State::open;
      while (!way.empty()) {
        const std::size_t k = way.back();
        if (next[k] == begin[k + 1]) {
          state[k] = State::done;
          way.pop_back();
          continue;
        }
        const std::size_t child = to[next[k]++];
        if (state[child] == State::open)
          throw FileError(path_, used_[next[k] - 1].line,
                          fmt::format("entity #{} leads back to itself", defined_[child].id));
        if (state[child] == State::fresh) {
          state[child] = State::open;
          way.push_back(child);
        }
      }
    }
  }

  const char* p_;
  const char* end_;
  const std::string& path_;
  long long line_ = 1;
  std::string_view type_;  ///< of the entity that is being read
  std::vector<Place> defined_;
  std::vector<Reference> used_;
};

}  // namespace

bool looks_like_step(std::string_view bytes) {
  return bytes.substr(0, 1024).find(kFirst) != std::string_view::npos;
}

void check_step(std::string_view bytes, const std::string& path) {
  if (!bytes.ends_with(kLast))
    throw FileError(path, fmt::format("the STEP file is cut off: it does not end with {}", kLast));
  Scanner(bytes, path).run();
}

}  // namespace knotfit::cad
