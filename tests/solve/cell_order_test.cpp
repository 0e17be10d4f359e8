#include "solve/cell_order.h"

#include <gtest/gtest.h>

#include <set>

#include "knotfit/threads.h"
#include "support/dense_reference.h"
namespace knotfit::test {
namespace {

/// Half of the points in a corner of 1e-3, so that one cell is longer than a chunk.
ParameterizedPoints clustered(Random& random, Index n) {
  ParameterizedPoints points = random_points(random, n, 2, true);
  for (std::size_t k = 0; k < points.uv.size() / 2; ++k) points.uv[k] *= 1e-3;
  return points;
}

TEST(CellOrder, PutsEveryPointIntoItsCellOnce) {
  Random random;
  for (bool swapped : {false, true}) {
    const ParameterizedPoints points = clustered(random, 20000);
    const Axis outer(3, random_interior(random, 7, 4)), inner(2, random_interior(random, 4));
    CellOrder order(points);
    order.sort(outer, inner, swapped);
    ASSERT_EQ(order.size(), points.size());
    std::set<Index> seen;
    Index at = 0, cell = -1;
    std::vector<Index> count(static_cast<std::size_t>(outer.spans() * inner.spans()), 0);
    for (const CellPiece& piece : order.pieces()) {
      EXPECT_EQ(piece.begin, at);
      EXPECT_GT(piece.end, piece.begin);
      EXPECT_LE(piece.end - piece.begin, kChunk);
      EXPECT_GE(piece.cell, cell);
      at = piece.end;
      cell = piece.cell;
      count[cell] += piece.end - piece.begin;
      for (Index k = piece.begin; k < piece.end; ++k) {
        const Index i = order.input(order.stored(k));
        EXPECT_TRUE(seen.insert(i).second) << "point " << i << " twice";
        const double x = swapped ? points.v(i) : points.u(i), y = swapped ? points.u(i) : points.v(i);
        EXPECT_EQ(outer.span(x) * inner.spans() + inner.span(y), cell);
        EXPECT_EQ(order.outer(k), outer.local(outer.span(x), x));
        EXPECT_EQ(order.inner(k), inner.local(inner.span(y), y));
        EXPECT_EQ(order.weight(k), points.weight(i));
        for (int d = 0; d < 2; ++d) EXPECT_EQ(order.value(k)[d], points.value(i)[d]);
      }
    }
    EXPECT_EQ(at, points.size());
    EXPECT_GT(*std::max_element(count.begin(), count.end()), 2 * kChunk);
    Index empty = 0;
    for (Index c = 0; c < outer.spans() * inner.spans(); ++c) {
      const Index first = order.piece_start()[c], last = order.piece_start()[c + 1];
      EXPECT_EQ(last - first, chunk_count(count[c]));
      for (Index p = first; p < last; ++p) EXPECT_EQ(order.pieces()[p].cell, c);
      empty += count[c] == 0 && outer.length(c / inner.spans()) > 0 && inner.length(c % inner.spans()) > 0;
    }
    EXPECT_EQ(order.empty_cells(), empty);
  }
}

TEST(CellOrder, HoldsOnePointAndPointsOnTheBorder) {
  ParameterizedPoints points;
  points.uv = {1, 1};
  points.values = {5};
  CellOrder order(points);
  const Axis axis(3, std::vector{0.5});
  order.sort(axis, axis, false);
  ASSERT_EQ(order.pieces().size(), 1u);
  EXPECT_EQ(order.pieces()[0].cell, 3);
  EXPECT_EQ(order.outer(0), 1);
  EXPECT_EQ(order.weight(0), 1);
  EXPECT_EQ(order.empty_cells(), 3);
}

TEST(CellOrder, IsTheSameForAnyNumberOfThreads) {
  Random random;
  const ParameterizedPoints points = clustered(random, 100000);
  const Axis outer(3, random_interior(random, 30)), inner(3, random_interior(random, 20));
  std::vector<Index> first;
  for (int threads : {1, 2, 4}) {
    set_thread_count(threads);
    CellOrder order(points);
    order.sort(inner, outer, true);
    order.sort(outer, inner, false);
    std::vector<Index> input;
    for (Index k = 0; k < order.size(); ++k) input.push_back(order.input(order.stored(k)));
    if (threads == 1) first = input;
    EXPECT_EQ(input, first) << threads << " threads";
  }
  set_thread_count(0);
}

}  // namespace
}  // namespace knotfit::test
