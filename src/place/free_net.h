// The error as a function of control points and knots together, for methods that do not eliminate either [METHOD 2.3].
#pragma once
#include <vector>

#include "knotfit/interior_knots.h"
#include "knotfit/points.h"
#include "solve/axis.h"
namespace knotfit {

/// phi(c, U, V) = sum w |S - P|^2 at control points c that need not minimise it, with its gradient by them and by
/// the interior knots, u before v [Piegl98].
struct FreeNet {
  double phi = 0;
  std::vector<double> by_net;    ///< 2 A^T W r, size_u x size_v x dimension
  std::vector<double> by_knots;  ///< 2 sum w r . dS/du_k; empty where not asked
  FreeNet& operator+=(const FreeNet& o);
};

/// \param with_knots  differentiate by the knots too
FreeNet free_net(const ParameterizedPoints& points, const Axis& u, const Axis& v,
                 const std::vector<double>& net, bool with_knots);

double dot(const std::vector<double>& a, const std::vector<double>& b);

/// Row sums of A^T W A, one a control point: bounds of its eigenvalues [Gershgorin; A >= 0].
std::vector<double> net_row_sums(const ParameterizedPoints& points, const Axis& u, const Axis& v);

/// The gradient by the logarithms of the knot spacings, chain rule of KnotSpacings, u before v.
std::vector<double> by_log_spacings(const InteriorKnots& knots, const std::vector<double>& by_knots);

}  // namespace knotfit
