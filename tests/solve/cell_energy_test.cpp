#include "solve/cell_energy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/random_splines.h"
#include "support/synthetic.h"
namespace knotfit {
namespace {

using namespace knotfit::test;

/// Q and g of the energy c^T Q c - 2 g c on a net of u outer and v inner, or the other way round.
struct Quadratic {
  BandMatrix matrix;
  std::vector<double> right;
  Quadratic(const DataEnergy& energy, const NetLayout& layout, double factor)
      : matrix(layout.outer.functions() * layout.inner.functions(),
               layout.outer.degree() * layout.inner.functions() + layout.inner.degree()),
        right(layout.outer.functions() * layout.inner.functions() * energy.dimension(), 0.0) {
    add_energy(energy, layout, factor, matrix, right);
  }
};

// Half the gradient of c^T Q c - 2 g c is Q c - g: one is made cell by cell from a net, the other from the matrix.
TEST(CellEnergy, GradientIsThatOfTheQuadraticForm) {
  Random random;
  const DataEnergy energy(data_raster(synthetic_points("franke", 800), 0.01));
  const Axis u(3, std::vector{0.2, 0.5, 0.6}), v(2, std::vector{0.4});
  const Index nu = u.functions(), nv = v.functions();
  const std::vector<double> net = random_numbers(random, nu * nv);
  for (const bool swapped : {false, true}) {
    const NetLayout layout = swapped ? NetLayout{v, u, true} : NetLayout{u, v, false};
    const Quadratic q(energy, layout, 3);
    std::vector<double> c(net.size());
    for (Index i = 0; i < nu; ++i)
      for (Index j = 0; j < nv; ++j) c[swapped ? j * nu + i : i * nv + j] = net[i * nv + j];
    const std::vector<double> product = q.matrix.times(c);
    std::vector<double> gradient(net.size(), 1.0);  // added to what is there
    add_energy_gradient(energy, layout, 3, net, gradient);
    double scale = 1;
    for (const double x : product) scale = std::max(scale, std::abs(x));
    for (std::size_t k = 0; k < net.size(); ++k)
      EXPECT_NEAR(gradient[k] - 1, product[k] - q.right[k], 1e-12 * scale)
          << k << (swapped ? " swapped" : "");
  }
}

TEST(CellEnergy, IsTheSameWhicheverDirectionIsOuter) {
  const DataEnergy energy(data_raster(synthetic_points("ridge", 500), 0.01));
  const Axis u(3, std::vector{0.3}), v(3, std::vector{0.2, 0.7});
  const Index nu = u.functions(), nv = v.functions();
  const Quadratic a(energy, {u, v, false}, 1), b(energy, {v, u, true}, 1);
  EXPECT_NEAR(a.matrix.trace(), b.matrix.trace(), 1e-12 * a.matrix.trace());
  double scale = 0;
  for (const double x : a.right) scale = std::max(scale, std::abs(x));
  ASSERT_GT(scale, 0);
  for (Index i = 0; i < nu; ++i)
    for (Index j = 0; j < nv; ++j) EXPECT_NEAR(a.right[i * nv + j], b.right[j * nu + i], 1e-12 * scale);
}

// A surface that does not bend or slope costs nothing but what the goals ask for.
TEST(CellEnergy, AConstantHasNoEnergy) {
  const DataEnergy energy(data_raster(synthetic_points("peaks", 500), 0.01));
  const Axis u(3, std::vector{0.3, 0.5}), v(2);
  const Quadratic q(energy, {u, v, false}, 1);
  for (const double x : q.matrix.times(std::vector<double>(u.functions() * v.functions(), 5.0)))
    EXPECT_NEAR(x, 0, 1e-11 * q.matrix.norm_1());
}

}  // namespace
}  // namespace knotfit
