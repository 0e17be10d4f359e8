#include "formats/column_guess.h"

#include "support.h"
namespace knotfit::test {
namespace {

using Words = std::vector<std::string>;
using Rows = std::vector<std::vector<double>>;

GuessedColumns guess(const Rows& rows, bool any_parameters = false) {
  ColumnValues values(static_cast<Index>(rows.front().size()));
  for (const auto& row : rows) values.take(row);
  return guess_columns(values, any_parameters);
}

/// x, y, z of some points, and what follows them.
Rows points(const Rows& rest) {
  Rows rows;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    const auto t = static_cast<double>(k);
    rows.push_back({5 - 1.5 * t, 0.3 * t * t, 2 + t});
    rows.back().insert(rows.back().end(), rest[k].begin(), rest[k].end());
  }
  return rows;
}

void expect_columns(const Rows& rest, const Words& words) {
  const GuessedColumns g = guess(points(rest));
  Words expected = {"x", "y", "z"};
  expected.insert(expected.end(), words.begin(), words.end());
  EXPECT_EQ(g.columns.told, expected) << g.why;
}

void expect_open(const Rows& rest, const Words& words) {
  const GuessedColumns g = guess(points(rest));
  EXPECT_TRUE(g.columns.empty()) << ::testing::PrintToString(g.columns.told);
  for (const std::string& word : words)
    EXPECT_NE(g.why.find(word), std::string::npos) << word << " in " << g.why;
}

TEST(ColumnGuess, OneMoreIsIntensity) {
  expect_columns({{}, {}, {}}, {});
  expect_columns({{-100}, {20}, {0.5}}, {"intensity"});
  expect_columns({{0.1}, {0.2}, {0.3}}, {"intensity"});
}

TEST(ColumnGuess, TwoInTheUnitIntervalAreParameters) {
  expect_columns({{0, 0.5}, {0.3, 0.25}, {1, 0}}, {"u", "v"});
  // A slip of one is a fault of parameters, to be named later.
  expect_columns({{0, 0.5}, {1.2, 0.25}, {1, 0}}, {"u", "v"});
  // Far outside they can be none.
  expect_columns({{181, 58}, {12, 30}, {90, 2}}, {"-", "-"});
  EXPECT_EQ(guess(points({{181, 58}, {12, 30}, {90, 2}}), true).columns.told,
            (Words{"x", "y", "z", "u", "v"}));
}

TEST(ColumnGuess, ThreeAreColoursNormalsOrParametersWithAWeight) {
  expect_columns({{181, 58, 90}, {0, 255, 3}, {12, 9, 1}}, {"r", "g", "b"});
  expect_columns({{0, 65535, 3}, {30000, 9, 1}, {1, 2, 3}}, {"r", "g", "b"});
  expect_columns({{181.5, 58.25, 90}, {0, 255, 3}, {12, 9, 1}}, {"r", "g", "b"});
  expect_columns({{0, 0, 1}, {0.6, 0, 0.8}, {-0.6, 0, 0.8}}, {"nx", "ny", "nz"});
  expect_columns({{0, 0, 1}, {0.6, 0, 0.8}, {0, 0, 0}}, {"nx", "ny", "nz"});
  expect_columns({{0.1, 0.2, 3}, {0.5, 0.9, 0.5}, {1, 0, 1}}, {"u", "v", "w"});
  // In [0,1] they may be colours, or parameters with a weight.
  expect_open({{0.7, 0.2, 0.35}, {0.1, 0.3, 0.35}, {0.2, 0.9, 0.35}},
              {"`columns = x,y,z,u,v,w`", "`columns = x,y,z,r,g,b`", "more than one reading"});
  // A weight of 0 is none: colours are left.
  expect_columns({{0.7, 0.2, 0}, {0.1, 0.3, 0.35}, {0.2, 0.9, 0.35}}, {"r", "g", "b"});
  expect_open({{-3, 0.2, 7.5}, {9, -2.3, 0.35}, {0.2, 0.9, 400.5}},
              {"fit no known reading", "`columns = x,y,z,nx,ny,nz`", "`columns = x,y,z,-,-,-`"});
}

TEST(ColumnGuess, MoreColumns) {
  expect_columns({{-1000, 181, 58, 90}, {5, 1, 2, 3}, {7, 9, 9, 255}}, {"intensity", "r", "g", "b"});
  expect_columns({{181, 58, 90, 0.5}, {1, 2, 3, 0.25}, {9, 9, 255, 0.1}}, {"r", "g", "b", "intensity"});
  expect_columns({{0, 0.6, 0.8, 12}, {0, 0, 1, 3}, {1, 0, 0, 3}}, {"nx", "ny", "nz", "-"});
  expect_columns({{12, 0, 0.6, 0.8}, {3, 0, 0, 1}, {3, 1, 0, 0}}, {"intensity", "nx", "ny", "nz"});
  expect_columns({{9, 9, 200, 0, 0.6, 0.8}, {1, 2, 3, 0, 0, 1}, {4, 5, 6, 1, 0, 0}},
                 {"r", "g", "b", "nx", "ny", "nz"});
  expect_columns({{0, 0.6, 0.8, 9, 9, 200}, {0, 0, 1, 1, 2, 3}, {1, 0, 0, 4, 5, 6}},
                 {"nx", "ny", "nz", "r", "g", "b"});
  expect_open({{0.5, 0.7, 0.2, 0.35}, {0.2, 0.1, 0.3, 0.35}, {0.1, 0.2, 0.9, 0.35}},
              {"`columns = x,y,z,u,v,w,intensity`"});
}

TEST(ColumnGuess, AFirstColumnThatCountsMayBeTheNumberOfThePoint) {
  Rows rows;
  for (int k = 0; k < 10; ++k) rows.push_back({1.0 + k, 0.3 * k, 0.1 * k * k, std::sin(k)});
  const GuessedColumns g = guess(rows);
  EXPECT_TRUE(g.columns.empty());
  EXPECT_NE(g.why.find("`columns = x,y,z,intensity` or `columns = -,x,y,z`"), std::string::npos) << g.why;
}

TEST(ColumnGuess, WhatIsMissingHindersNothing) {
  expect_columns({{181, 58, kNan}, {0, 255, 3}, {12, 9, 1}}, {"r", "g", "b"});
  expect_columns({{0, 0, 1}, {kNan, kNan, kNan}, {0.6, 0, 0.8}}, {"nx", "ny", "nz"});
}

TEST(ColumnGuess, TextAndArraysByTheSameRules) {
  const Rows rows = points({{181, 58, 90},
                            {0, 255, 3},
                            {12, 9, 1},
                            {1, 2, 3},
                            {4, 5, 6},
                            {7, 8, 9},
                            {1, 1, 1},
                            {2, 2, 2},
                            {3, 3, 3},
                            {4, 4, 4},
                            {5, 5, 5}});
  std::string text;
  std::vector<double> flat, turned;
  for (const auto& row : rows)
    for (std::size_t c = 0; c < row.size(); ++c) {
      text += std::to_string(row[c]) + (c + 1 == row.size() ? "\n" : " ");
      flat.push_back(row[c]);
    }
  const SourceData a = read("a.xyz", text), b = read("a.npy", doubles("11, 6", flat));
  const Words words = {"x", "y", "z", "r", "g", "b"};
  EXPECT_EQ(a.columns, words);
  EXPECT_EQ(b.columns, words);
  EXPECT_EQ(content<PointTable>(a).x, content<PointTable>(b).x);
  EXPECT_TRUE(content<PointTable>(b).u.empty());
  refuses("a.xyz", "1 2 3 0.1 0.2 0.3\n4 5 6 0.3 0.1 0.2\n2 2 1 0.5 0.6 0.7\n",
          "a.xyz:1: 6 columns and no header line");
}

}  // namespace
}  // namespace knotfit::test
