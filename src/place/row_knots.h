// Knots from parameters picked along rows: what the methods made for rows of points share.
#pragma once
#include <span>
#include <vector>

#include "knotfit/interior_knots.h"
namespace knotfit {

/// u_j = (r_j + ... + r_{j+m-1})/m, j = 1..k, for k + m + 1 values r_0..r_{k+m}: none where there are fewer than
/// m + 2 of them.
std::vector<double> averaged_knots(std::span<const double> r, int degree);

/// nktp.cpp
std::vector<double> nktp_knots(std::span<const double> t, int count, int degree);

/// Makes knots a placement: halves the longest spans until the counts are there, leaves the first of too many,
/// and keeps spans at 1 % of the mean.
void settle_knots(InteriorKnots& knots, int interior_u, int interior_v);

}  // namespace knotfit
