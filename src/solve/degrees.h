// Code compiled for each of the common degrees, so that the matrices of a cell have sizes known to the compiler.
#pragma once
namespace knotfit {

inline constexpr int kDynamic = -1;  ///< known when it runs: Eigen::Dynamic

/// Calls body.operator()<degree>() with the common degree, or <kDynamic> where the two differ or pass 5.
template <class Body>
void for_degrees(int outer, int inner, const Body& body) {
  if (outer != inner) return body.template operator()<kDynamic>();
  switch (outer) {
    case 1:
      return body.template operator()<1>();
    case 2:
      return body.template operator()<2>();
    case 3:
      return body.template operator()<3>();
    case 4:
      return body.template operator()<4>();
    case 5:
      return body.template operator()<5>();
    default:
      return body.template operator()<kDynamic>();
  }
}
constexpr int width_of(int degree) {
  return degree < 0 ? kDynamic : degree + 1;
}
constexpr int moments_of(int degree) {
  return degree < 0 ? kDynamic : 2 * degree + 1;
}
constexpr int pairs_of(int degree) {
  return degree < 0 ? kDynamic : (degree + 1) * (degree + 2) / 2;
}

}  // namespace knotfit
