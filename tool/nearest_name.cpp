#include "nearest_name.h"

#include <algorithm>
namespace knotfit::tool {
namespace {

std::string plain(std::string_view name) {
  std::string text;
  for (const char c : name.substr(std::min(name.find_first_not_of('-'), name.size())))
    text += c == '_' ? '-' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  return text;
}

/// Letters changed, left out, added, or neighbours swapped, on the way from one to the other (optimal string alignment).
std::size_t steps_between(const std::string& a, const std::string& b) {
  std::vector<std::size_t> before, last(b.size() + 1), row(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        row[j] = std::min(row[j], before[j - 2] + 1);
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

/// One is the beginning of the other, or its end from a dash on.
bool is_part(const std::string& a, const std::string& b) {
  const std::string& shorter = a.size() < b.size() ? a : b;
  const std::string& longer = a.size() < b.size() ? b : a;
  if (shorter.size() < 3) return false;
  return longer.starts_with(shorter) || longer.ends_with("-" + shorter);
}

}  // namespace

std::string nearest_name(std::string_view word, const std::vector<std::string>& names) {
  const std::string wanted = plain(word);
  std::string best;
  // In halves of a letter: a part of a name is less than one letter off, and more than none.
  std::size_t least = 2 * std::max<std::size_t>(1, (wanted.size() + 1) / 3) + 2;
  for (const std::string& name : names) {
    const std::string other = plain(name);
    const std::size_t steps = steps_between(wanted, other);
    if (steps >= std::max(wanted.size(), other.size())) continue;  // all letters changed are no likeness
    const std::size_t off = is_part(wanted, other) ? std::min<std::size_t>(2 * steps, 3) : 2 * steps;
    if (off < least) least = off, best = name;
  }
  return best;
}

}  // namespace knotfit::tool
