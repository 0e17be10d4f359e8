// Small matrices of a cell, of sizes known to the compiler for the common degrees.
#pragma once
#include <Eigen/Dense>
namespace knotfit {

template <int rows, int columns>
using ConstMap =
    Eigen::Map<const Eigen::Matrix<double, rows, columns,
                                   (rows != 1 && columns == 1) ? Eigen::ColMajor : Eigen::RowMajor>>;
template <int rows, int columns>
using Matrix = Eigen::Matrix<double, rows, columns, Eigen::RowMajor>;

/// Calls body.operator()<degree>() with the common degree, or <Dynamic> where the two differ or pass 5.
template <class Body>
void for_degrees(int outer, int inner, const Body& body) {
  if (outer != inner) return body.template operator()<Eigen::Dynamic>();
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
      return body.template operator()<Eigen::Dynamic>();
  }
}
constexpr int width_of(int degree) {
  return degree < 0 ? Eigen::Dynamic : degree + 1;
}
constexpr int moments_of(int degree) {
  return degree < 0 ? Eigen::Dynamic : 2 * degree + 1;
}
constexpr int pairs_of(int degree) {
  return degree < 0 ? Eigen::Dynamic : (degree + 1) * (degree + 2) / 2;
}

}  // namespace knotfit
