// Points of curves read from text, and what the reader says of them.
#pragma once
#include <algorithm>

#include "support.h"
namespace knotfit::test {

inline SourceData curve(std::string_view text, const std::string& name = "a.dat", Index block = 0) {
  ReadOptions options;
  options.curve = options.places = true;
  options.block = block;
  return read(name, text, options);
}

inline void expect_note(const SourceData& data, const std::string& words) {
  const bool there = std::any_of(data.notes.begin(), data.notes.end(), [&](const std::string& note) {
    return note.find(words) != std::string::npos;
  });
  EXPECT_TRUE(there) << words << " in:" << ::testing::PrintToString(data.notes);
}

}  // namespace knotfit::test
