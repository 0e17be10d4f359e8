#include "parameterize/mesh_newton.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "parameterize/mesh_border.h"
#include "parameterize/mesh_stretch_energy.h"
namespace knotfit::mesh_map {

NewtonMap::NewtonMap(const DiskMesh& disk, const std::vector<RestTriangle>& rest,
                     const Elimination& elimination, std::vector<double> uv)
    : disk_(disk), rest_(rest), cholesky_(elimination), fixed_(fixed_coordinates(disk, uv)) {
  for (int f = 0; f < disk.face_count(); ++f)
    if (!disk.virtual_face[f]) area_ += rest[f].area;
  aspect_ = measure_stretch(disk, rest, uv).aspect;
  plane_ = std::move(uv);
  for (std::size_t i = 0; i < plane_.size(); i += 2) {
    plane_[i] *= width();
    plane_[i + 1] *= height();
  }
  energy_ = energy_at(plane_);
}

double NewtonMap::width() const {
  return std::sqrt(area_ * aspect_);
}
double NewtonMap::height() const {
  return std::sqrt(area_ / aspect_);
}

double NewtonMap::energy_at(std::span<const double> plane) const {
  double sum = 0;
  for (int f = 0; f < disk_.face_count(); ++f)
    sum += disk_.weight(f) * rest_[f].area * stretch_energy(jacobian(rest_[f], disk_.face[f], plane.data()));
  return sum / area_;
}

void NewtonMap::assemble() {
  gradient_.assign(plane_.size(), 0);
  diagonal_.assign(2 * plane_.size(), 0);
  off_.assign(4 * disk_.edge.size(), 0);
  for (int f = 0; f < disk_.face_count(); ++f) {
    const Face& t = disk_.face[f];
    const RestTriangle& rest = rest_[f];
    const EnergyDerivatives d = stretch_energy_derivatives(jacobian(rest, t, plane_.data()));
    const double weight = disk_.weight(f) * rest.area / area_;
    for (int a = 0; a < 3; ++a) {
      // Row a of the element matrix: (gx, gy)_a^T H (gx, gy)_b for each pair of coordinates.
      double row[2][4];
      for (int x = 0; x < 2; ++x) {
        for (int k = 0; k < 4; ++k)
          row[x][k] = weight * (rest.gx[a] * d.hessian[2 * x][k] + rest.gy[a] * d.hessian[2 * x + 1][k]);
        gradient_[2 * static_cast<std::size_t>(t[a]) + x] +=
            weight * (rest.gx[a] * d.gradient[2 * x] + rest.gy[a] * d.gradient[2 * x + 1]);
      }
      for (int b = 0; b < 3; ++b) {
        double* block = nullptr;
        if (a == b) {
          block = &diagonal_[4 * static_cast<std::size_t>(t[a])];
        } else {
          const int e = disk_.face_edge[f][3 - a - b];
          if (disk_.edge[e][0] != t[a]) continue;
          block = &off_[4 * static_cast<std::size_t>(e)];
        }
        for (int x = 0; x < 2; ++x)
          for (int y = 0; y < 2; ++y)
            block[2 * x + y] += row[x][2 * y] * rest.gx[b] + row[x][2 * y + 1] * rest.gy[b];
      }
    }
  }
  // A coordinate fixed to its side becomes an equation of its own.
  for (const int i : disk_.loop)
    for (int x = 0; x < 2; ++x) {
      if (!(fixed_[i] >> x & 1)) continue;
      gradient_[2 * static_cast<std::size_t>(i) + x] = 0;
      double* block = &diagonal_[4 * static_cast<std::size_t>(i)];
      block[1] = block[2] = 0;
      block[3 * x] = 1;
    }
  for (std::size_t e = 0; e < disk_.edge.size(); ++e) {
    const auto [a, b] = disk_.edge[e];
    for (int x = 0; x < 2; ++x)
      for (int y = 0; y < 2; ++y)
        if ((fixed_[a] >> x & 1) || (fixed_[b] >> y & 1)) off_[4 * e + 2 * x + y] = 0;
  }
}

bool NewtonMap::factor() {
  double mean = 0;
  for (std::size_t i = 0; i < diagonal_.size(); i += 4) mean += diagonal_[i] + diagonal_[i + 3];
  mean /= static_cast<double>(plane_.size());
  double added = 0;
  for (double shift = 1e-9 * mean; shift < mean; shift *= 100) {
    for (std::size_t i = 0; i < diagonal_.size(); i += 4) {
      diagonal_[i] += shift - added;
      diagonal_[i + 3] += shift - added;
    }
    added = shift;
    if (cholesky_.factor(diagonal_, off_)) return true;
  }
  return false;
}

// Least t > 0 at which det(J + t dJ) = 0 in some triangle.
double NewtonMap::first_flattening(std::span<const double> direction) const {
  double first = std::numeric_limits<double>::infinity();
  for (int f = 0; f < disk_.face_count(); ++f) {
    const Jacobian j = jacobian(rest_[f], disk_.face[f], plane_.data());
    const Jacobian d = jacobian(rest_[f], disk_.face[f], direction.data());
    const double c0 = j.determinant(), c2 = d.determinant();
    const double c1 = j.xu * d.yv + d.xu * j.yv - j.xv * d.yu - d.xv * j.yu;
    const double discriminant = c1 * c1 - 4 * c2 * c0;
    if (discriminant < 0) continue;
    const double s = -0.5 * (c1 + std::copysign(std::sqrt(discriminant), c1));
    for (const double t : {s / c2, c0 / s})
      if (t > 0 && t < first) first = t;
  }
  return first;
}

bool NewtonMap::step(std::span<const double> direction) {
  double slope = 0;
  for (std::size_t i = 0; i < direction.size(); ++i) slope += gradient_[i] * direction[i];
  if (!(slope < 0)) return false;
  double length = std::min(1.0, 0.9 * first_flattening(direction));
  std::vector<double> next(plane_.size());
  for (int halving = 0; halving < 30; ++halving, length /= 2) {
    for (std::size_t i = 0; i < next.size(); ++i) next[i] = plane_[i] + length * direction[i];
    const double energy = energy_at(next);
    if (energy <= energy_ + 1e-4 * length * slope) {  // Armijo
      plane_ = std::move(next);
      energy_ = energy;
      return true;
    }
  }
  return false;
}

void NewtonMap::renew_aspect() {
  std::vector<double> other = square_parameters();
  const double before = aspect_;
  aspect_ = measure_stretch(disk_, rest_, other).aspect;
  for (std::size_t i = 0; i < other.size(); i += 2) {
    other[i] *= width();
    other[i + 1] *= height();
  }
  const double energy = energy_at(other);
  if (energy < energy_) {
    plane_ = std::move(other);
    energy_ = energy;
  } else {
    aspect_ = before;
  }
}

void NewtonMap::round(double tolerance) {
  const double before = energy_;
  assemble();
  if (!factor()) {
    converged_ = true;
    return;
  }
  std::vector<double> direction = gradient_;
  cholesky_.solve(direction);
  for (double& x : direction) x = -x;
  const bool moved = step(direction);
  ++rounds_;
  if (moved) renew_aspect();
  converged_ = !moved || before - energy_ < tolerance * before;
}

void NewtonMap::advance(int rounds, double tolerance, const std::function<bool()>& stop) {
  for (int k = 0; k < rounds && !converged_ && std::isfinite(energy_); ++k) {
    if (stop && stop()) return;
    round(tolerance);
  }
}

void NewtonMap::release() {
  cholesky_.release();
  std::vector<double>().swap(gradient_);
  std::vector<double>().swap(diagonal_);
  std::vector<double>().swap(off_);
}

std::vector<double> NewtonMap::square_parameters() const {
  std::vector<double> uv = plane_;
  for (std::size_t i = 0; i < uv.size(); i += 2) {
    const char fixed = fixed_[i / 2];
    uv[i] = fixed & 1 ? std::round(uv[i] / width()) : std::clamp(uv[i] / width(), 0.0, 1.0);
    uv[i + 1] = fixed & 2 ? std::round(uv[i + 1] / height()) : std::clamp(uv[i + 1] / height(), 0.0, 1.0);
  }
  return uv;
}

}  // namespace knotfit::mesh_map
