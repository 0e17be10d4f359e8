// Where the Gram matrix of a cell goes in the matrix of all functions.
#pragma once
#include "knotfit/index.h"
namespace knotfit {

/// The first functions alive on a cell, outer and inner; a function has the number outer * functions + inner.
struct CellFunctions {
  Index outer, inner;
  int outer_width, inner_width;
  Index functions;  ///< inner ones in all
};

/// Calls add(x, y, row, column), x >= y numbers of functions, for every entry of the lower half. Row and column are those
/// of the cell's matrix, the pairs i >= i2 of outer functions by the pairs j >= j2 of inner ones.
template <class Add>
void each_gram_entry(const CellFunctions& cell, const Add& add) {
  int row = 0;
  for (int i = 0; i < cell.outer_width; ++i)
    for (int i2 = 0; i2 <= i; ++i2, ++row) {
      const Index x = (cell.outer + i) * cell.functions + cell.inner,
                  y = (cell.outer + i2) * cell.functions + cell.inner;
      int column = 0;
      for (int j = 0; j < cell.inner_width; ++j)
        for (int j2 = 0; j2 <= j; ++j2, ++column) {
          add(x + j, y + j2, row, column);
          if (i != i2 && j != j2) add(x + j2, y + j, row, column);
        }
    }
}

}  // namespace knotfit
