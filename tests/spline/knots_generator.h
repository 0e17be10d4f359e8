// Knot vectors for RapidCheck, built from small integers so that failures shrink to readable ones.
#pragma once
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <vector>

#include "knotfit/knot_vector.h"
namespace knotfit::test {

inline rc::Gen<KnotVector> clamped_knots(int least_degree = 1) {
  return rc::gen::map(rc::gen::pair(rc::gen::inRange(least_degree, kMaxDegree + 1),
                                    rc::gen::container<std::vector<int>>(rc::gen::inRange(1, 16))),
                      [](std::pair<int, std::vector<int>> input) {
                        auto& [degree, places] = input;
                        std::sort(places.begin(), places.end());
                        std::vector<double> interior;
                        for (int place : places)
                          if (std::count(interior.begin(), interior.end(), place / 16.0) <= degree)
                            interior.push_back(place / 16.0);
                        return KnotVector::clamped(degree, interior);
                      });
}

/// A parameter of [0,1]; knots, being sixteenths, are hit often.
inline rc::Gen<double> parameter() {
  return rc::gen::oneOf(rc::gen::map(rc::gen::inRange(0, 17), [](int k) { return k / 16.0; }),
                        rc::gen::map(rc::gen::inRange(0, 1000001), [](int k) { return k * 1e-6; }));
}

}  // namespace knotfit::test

namespace rc {
inline void showValue(const knotfit::KnotVector& knots, std::ostream& out) {
  out << "degree " << knots.degree() << ", knots";
  for (double t : knots.knots()) out << " " << t;
}
}  // namespace rc
