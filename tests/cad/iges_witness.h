// The B-spline surfaces of an IGES file by a parser that shares nothing with OpenCASCADE [IGES 5.3, entity 128].
#pragma once
#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "knotfit/surface.h"
namespace knotfit::test {

class IgesFile {
 public:
  explicit IgesFile(const std::string& text) {
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
      if (line.size() != 80) throw std::runtime_error("no line of 80: " + line);
      if (line[72] == 'G') global_ += line.substr(0, 72);
      if (line[72] == 'P') parameters_[std::stoi(line.substr(64, 8))] += line.substr(0, 64);
      if (line[72] == 'D') directory_ += line + "\n";
    }
  }
  const std::string& global() const { return global_; }
  const std::string& directory() const { return directory_; }

  std::vector<Surface> surfaces() const {
    std::vector<Surface> found;
    for (const auto& [pointer, text] : parameters_)
      if (text.starts_with("128,")) found.push_back(surface(text));
    return found;
  }
  int count(const std::string& type) const {
    int n = 0;
    for (const auto& [pointer, text] : parameters_) n += text.starts_with(type + ",");
    return n;
  }

 private:
  static Surface surface(const std::string& text) {
    std::vector<double> x;
    std::istringstream in(text.substr(0, text.find(';')));
    for (std::string part; std::getline(in, part, ',');) {
      std::replace(part.begin(), part.end(), 'D', 'E');
      x.push_back(std::stod(part));
    }
    // 128, K1, K2, M1, M2, closed u and v, polynomial, periodic u and v, then knots, weights, points u fastest.
    const auto count = [&](std::size_t k) { return static_cast<std::size_t>(x.at(k)); };
    const std::size_t nu = count(1) + 1, nv = count(2) + 1, p = count(3), q = count(4);
    if (x.at(7) != 1) throw std::runtime_error("not marked as polynomial");
    auto at = x.begin() + 10;
    const auto take = [&](std::size_t n) {
      if (static_cast<std::size_t>(x.end() - at) < n) throw std::runtime_error("too short");
      std::vector<double> values(at, at + static_cast<std::ptrdiff_t>(n));
      at += static_cast<std::ptrdiff_t>(n);
      return values;
    };
    std::vector<double> u = take(nu + p + 1), v = take(nv + q + 1);
    for (const double w : take(nu * nv))
      if (w != 1) throw std::runtime_error("rational");
    const std::vector<double> c = take(3 * nu * nv);
    const std::vector<double> bounds = take(4);
    if (bounds != std::vector<double>{u[p], u[nu], v[q], v[nv]}) throw std::runtime_error("bounds");
    std::vector<double> net(c.size());
    for (std::size_t i = 0; i < nu; ++i)
      for (std::size_t j = 0; j < nv; ++j)
        for (std::size_t d = 0; d < 3; ++d) net[(i * nv + j) * 3 + d] = c[(j * nu + i) * 3 + d];
    return Surface(KnotVector(static_cast<int>(p), std::move(u)),
                   KnotVector(static_cast<int>(q), std::move(v)), 3, std::move(net));
  }

  std::string global_, directory_;
  std::map<int, std::string> parameters_;
};

}  // namespace knotfit::test
