#include "parameterize/mesh_factor.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
namespace knotfit::mesh_map {
namespace {

using Dense = Eigen::Map<Eigen::MatrixXd, 0, Eigen::OuterStride<>>;

constexpr int kPanel = 32;       // columns eliminated between updates of the rest
constexpr double kSmall = 4096;  // multiplications below which plain loops beat packed products

Dense block(double* front, int stride, int row, int column, int rows, int columns) {
  return {front + static_cast<std::ptrdiff_t>(column) * stride + row, rows, columns,
          Eigen::OuterStride<>(stride)};
}

// Lower part of C -= P P^T, C size x size below the panel P of `depth` columns.
void subtract_square(double* front, int stride, int from, int size, int panel, int depth) {
  if (size <= 0) return;
  if (static_cast<double>(size) * size * depth > kSmall) {
    const Dense p = block(front, stride, from, panel, size, depth);
    Dense c = block(front, stride, from, from, size, size);
    c.selfadjointView<Eigen::Lower>().rankUpdate(p, -1.0);
    return;
  }
  for (int k = panel; k < panel + depth; ++k) {
    const double* p = front + static_cast<std::ptrdiff_t>(k) * stride;
    for (int j = from; j < from + size; ++j) {
      double* c = front + static_cast<std::ptrdiff_t>(j) * stride;
      const double factor = p[j];
      for (int i = j; i < from + size; ++i) c[i] -= p[i] * factor;
    }
  }
}

// Cholesky of the first `width` columns of a front, the rest updated. Lower part only.
bool eliminate_symmetric(double* front, int size, int width) {
  for (int begin = 0; begin < width; begin += kPanel) {
    const int end = std::min(begin + kPanel, width);
    for (int k = begin; k < end; ++k) {
      double* column = front + static_cast<std::ptrdiff_t>(k) * size;
      if (!(column[k] > 0)) return false;
      const double pivot = std::sqrt(column[k]), inverse = 1 / pivot;
      column[k] = pivot;
      for (int i = k + 1; i < size; ++i) column[i] *= inverse;
      for (int j = k + 1; j < end; ++j) {
        double* c = front + static_cast<std::ptrdiff_t>(j) * size;
        const double factor = column[j];
        for (int i = j; i < size; ++i) c[i] -= column[i] * factor;
      }
    }
    subtract_square(front, size, end, size - end, begin, end - begin);
  }
  return true;
}

// LU of the first `width` rows and columns of a front, the rest updated. L has a unit diagonal.
bool eliminate_unsymmetric(double* front, int size, int width) {
  for (int begin = 0; begin < width; begin += kPanel) {
    const int end = std::min(begin + kPanel, width);
    for (int k = begin; k < end; ++k) {
      double* column = front + static_cast<std::ptrdiff_t>(k) * size;
      if (!(std::abs(column[k]) > 0) || !std::isfinite(column[k])) return false;
      const double inverse = 1 / column[k];
      for (int i = k + 1; i < size; ++i) column[i] *= inverse;
      for (int j = k + 1; j < end; ++j) {
        double* c = front + static_cast<std::ptrdiff_t>(j) * size;
        const double factor = c[k];
        if (factor == 0) continue;
        for (int i = k + 1; i < size; ++i) c[i] -= column[i] * factor;
      }
    }
    for (int j = end; j < size; ++j) {  // the panel's rows of U
      double* c = front + static_cast<std::ptrdiff_t>(j) * size;
      for (int k = begin; k < end; ++k) {
        const double* column = front + static_cast<std::ptrdiff_t>(k) * size;
        const double factor = c[k];
        for (int i = k + 1; i < end; ++i) c[i] -= column[i] * factor;
      }
    }
    const int rest = size - end, depth = end - begin;
    if (rest <= 0) continue;
    if (static_cast<double>(rest) * rest * depth > kSmall) {
      Dense c = block(front, size, end, end, rest, rest);
      c.noalias() -=
          block(front, size, end, begin, rest, depth) * block(front, size, begin, end, depth, rest);
      continue;
    }
    for (int j = end; j < size; ++j) {
      double* c = front + static_cast<std::ptrdiff_t>(j) * size;
      for (int k = begin; k < end; ++k) {
        const double* column = front + static_cast<std::ptrdiff_t>(k) * size;
        const double factor = c[k];
        for (int i = end; i < size; ++i) c[i] -= column[i] * factor;
      }
    }
  }
  return true;
}

// Updates that wait for their parent front.
class Updates {
 public:
  Updates(const std::vector<Front>& fronts, int scale)
      : fronts_(fronts), scale_(scale), waiting_(fronts.size()), children_(fronts.size()) {
    for (int f = 0; f < static_cast<int>(fronts.size()); ++f)
      if (fronts[f].parent >= 0) children_[fronts[f].parent].push_back(f);
  }
  // Adds what the children of f left to its front, lower part or all of it.
  void add_to(int f, double* front, int size, bool lower) {
    for (const int child : children_[f]) {
      const std::vector<int>& into = fronts_[child].into_parent;
      const int rows = scale_ * static_cast<int>(into.size());
      const double* update = waiting_[child].data();
      for (int j = 0; j < rows; ++j) {
        double* to = front + static_cast<std::ptrdiff_t>(scale_ * into[j / scale_] + j % scale_) * size;
        const double* from = update + static_cast<std::ptrdiff_t>(j) * rows;
        const int start = lower ? j / scale_ * scale_ : 0;
        for (int i = start; i < rows; i += scale_)
          for (int c = 0; c < scale_; ++c) to[scale_ * into[i / scale_] + c] += from[i + c];
      }
      std::vector<double>().swap(waiting_[child]);
    }
  }
  void keep(int f, const double* front, int size, int width) {
    const int rows = size - width;
    if (rows == 0) return;
    waiting_[f].resize(static_cast<std::size_t>(rows) * static_cast<std::size_t>(rows));
    for (int j = 0; j < rows; ++j)
      std::copy_n(front + static_cast<std::ptrdiff_t>(j + width) * size + width, rows,
                  waiting_[f].data() + static_cast<std::ptrdiff_t>(j) * rows);
  }

 private:
  const std::vector<Front>& fronts_;
  int scale_;
  std::vector<std::vector<double>> waiting_;
  std::vector<std::vector<int>> children_;
};

}  // namespace

bool BlockCholesky::factor(std::span<const double> diagonal, std::span<const double> off) {
  const std::vector<Front>& fronts = elimination_.fronts();
  columns_.resize(fronts.size());
  Updates updates(fronts, 2);
  std::vector<double> front;
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f) {
    const int size = 2 * static_cast<int>(fronts[f].rows.size()), width = 2 * fronts[f].width;
    front.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.0);
    auto at = [&](int row, int column) -> double& {
      return front[static_cast<std::size_t>(column) * size + row];
    };
    for (int k = 0; k < fronts[f].width; ++k) {
      const double* d = &diagonal[4 * static_cast<std::size_t>(elimination_.vertex(fronts[f].first + k))];
      at(2 * k, 2 * k) = d[0];
      at(2 * k + 1, 2 * k) = d[2];
      at(2 * k + 1, 2 * k + 1) = d[3];
    }
    for (const EdgeEntry& entry : elimination_.entries(f)) {
      const double* o = &off[4 * static_cast<std::size_t>(entry.edge)];
      const int r = 2 * entry.row, c = 2 * entry.column;
      at(r, c) = o[0];
      at(r + 1, c + 1) = o[3];
      at(r, c + 1) = entry.forward ? o[1] : o[2];
      at(r + 1, c) = entry.forward ? o[2] : o[1];
    }
    updates.add_to(f, front.data(), size, true);
    if (!eliminate_symmetric(front.data(), size, width)) return false;
    columns_[f].assign(front.begin(), front.begin() + static_cast<std::ptrdiff_t>(size) * width);
    updates.keep(f, front.data(), size, width);
  }
  return true;
}

void BlockCholesky::solve(std::span<double> x) const {
  const std::vector<Front>& fronts = elimination_.fronts();
  std::vector<double> local;
  auto slot = [&](const Front& front, int i) -> double& {
    return x[2 * static_cast<std::size_t>(elimination_.vertex(front.rows[i / 2])) + i % 2];
  };
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    const int size = 2 * static_cast<int>(fronts[f].rows.size()), width = 2 * fronts[f].width;
    local.assign(static_cast<std::size_t>(size), 0.0);
    for (int i = 0; i < width; ++i) local[i] = slot(fronts[f], i);
    for (int k = 0; k < width; ++k) {
      const double* column = columns_[f].data() + static_cast<std::ptrdiff_t>(k) * size;
      const double y = local[k] /= column[k];
      for (int i = k + 1; i < size; ++i) local[i] -= column[i] * y;
    }
    for (int i = 0; i < width; ++i) slot(fronts[f], i) = local[i];
    for (int i = width; i < size; ++i) slot(fronts[f], i) += local[i];
  }
  for (std::size_t f = fronts.size(); f-- > 0;) {
    const int size = 2 * static_cast<int>(fronts[f].rows.size()), width = 2 * fronts[f].width;
    local.resize(static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) local[i] = slot(fronts[f], i);
    for (int k = width - 1; k >= 0; --k) {
      const double* column = columns_[f].data() + static_cast<std::ptrdiff_t>(k) * size;
      double sum = local[k];
      for (int i = k + 1; i < size; ++i) sum -= column[i] * local[i];
      local[k] = sum / column[k];
    }
    for (int i = 0; i < width; ++i) slot(fronts[f], i) = local[i];
  }
}

bool DirectedLU::factor(std::span<const double> forward, std::span<const double> backward) {
  const std::vector<Front>& fronts = elimination_.fronts();
  lower_.resize(fronts.size());
  upper_.resize(fronts.size());
  Updates updates(fronts, 1);
  std::vector<double> front;
  for (int f = 0; f < static_cast<int>(fronts.size()); ++f) {
    const int size = static_cast<int>(fronts[f].rows.size()), width = fronts[f].width;
    front.assign(static_cast<std::size_t>(size) * static_cast<std::size_t>(size), 0.0);
    for (int k = 0; k < width; ++k) front[static_cast<std::size_t>(k) * size + k] = 1;
    for (const EdgeEntry& entry : elimination_.entries(f)) {
      const double below = entry.forward ? forward[entry.edge] : backward[entry.edge];
      const double right = entry.forward ? backward[entry.edge] : forward[entry.edge];
      front[static_cast<std::size_t>(entry.column) * size + entry.row] = below;
      front[static_cast<std::size_t>(entry.row) * size + entry.column] = right;
    }
    updates.add_to(f, front.data(), size, false);
    if (!eliminate_unsymmetric(front.data(), size, width)) return false;
    lower_[f].assign(front.begin(), front.begin() + static_cast<std::ptrdiff_t>(size) * width);
    upper_[f].resize(static_cast<std::size_t>(size - width) * static_cast<std::size_t>(width));
    for (int k = 0; k < width; ++k)
      for (int j = width; j < size; ++j)
        upper_[f][static_cast<std::size_t>(k) * (size - width) + j - width] =
            front[static_cast<std::size_t>(j) * size + k];
    updates.keep(f, front.data(), size, width);
  }
  return true;
}

void DirectedLU::solve(std::span<double> x) const {
  const std::vector<Front>& fronts = elimination_.fronts();
  std::vector<double> local;
  auto slot = [&](int place) { return &x[2 * static_cast<std::size_t>(elimination_.vertex(place))]; };
  for (std::size_t f = 0; f < fronts.size(); ++f) {
    const int size = static_cast<int>(fronts[f].rows.size()), width = fronts[f].width;
    local.assign(2 * static_cast<std::size_t>(size), 0.0);
    for (int i = 0; i < width; ++i) std::copy_n(slot(fronts[f].first + i), 2, &local[2 * i]);
    for (int k = 0; k < width; ++k) {
      const double* column = lower_[f].data() + static_cast<std::ptrdiff_t>(k) * size;
      const double a = local[2 * k], b = local[2 * k + 1];
      for (int i = k + 1; i < size; ++i) {
        local[2 * i] -= column[i] * a;
        local[2 * i + 1] -= column[i] * b;
      }
    }
    for (int i = 0; i < width; ++i) std::copy_n(&local[2 * i], 2, slot(fronts[f].first + i));
    for (int i = width; i < size; ++i) {
      double* to = slot(fronts[f].rows[i]);
      to[0] += local[2 * i];
      to[1] += local[2 * i + 1];
    }
  }
  for (std::size_t f = fronts.size(); f-- > 0;) {
    const int size = static_cast<int>(fronts[f].rows.size()), width = fronts[f].width;
    local.resize(2 * static_cast<std::size_t>(size));
    for (int i = 0; i < size; ++i) std::copy_n(slot(fronts[f].rows[i]), 2, &local[2 * i]);
    for (int k = width - 1; k >= 0; --k) {
      double a = local[2 * k], b = local[2 * k + 1];
      const double* right = upper_[f].data() + static_cast<std::ptrdiff_t>(k) * (size - width);
      for (int j = 0; j < size - width; ++j) {
        a -= right[j] * local[2 * (j + width)];
        b -= right[j] * local[2 * (j + width) + 1];
      }
      for (int j = k + 1; j < width; ++j) {
        const double u = lower_[f][static_cast<std::size_t>(j) * size + k];
        a -= u * local[2 * j];
        b -= u * local[2 * j + 1];
      }
      const double pivot = lower_[f][static_cast<std::size_t>(k) * size + k];
      local[2 * k] = a / pivot;
      local[2 * k + 1] = b / pivot;
    }
    for (int i = 0; i < width; ++i) std::copy_n(&local[2 * i], 2, slot(fronts[f].first + i));
  }
}

}  // namespace knotfit::mesh_map
