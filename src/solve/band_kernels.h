// The loops over rows of band matrices and of their right-hand sides.
#pragma once
#include "knotfit/index.h"
namespace knotfit {

/// Cholesky factor in place, lower band storage. For narrow bands: there LAPACK's dpbtrf goes column by column
/// through calls too short to pay. \return false at a pivot that is not positive
bool factor_narrow_band(double* band, Index rows, Index bandwidth);

/// x <- L^-1 x for 8 columns side by side, x rows x 8; L in lower band storage.
void forward_block(const double* factor, Index rows, Index bandwidth, double* x);

/// products[i * 8 + j] = sum over rows of x[row * 8 + i] y[row * 8 + j].
void block_products(const double* x, const double* y, Index rows, double* products);

}  // namespace knotfit
