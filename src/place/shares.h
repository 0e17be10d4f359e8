// Equal shares of a density over spans, and spans kept from vanishing.
#pragma once
#include <span>
#include <vector>
namespace knotfit {

/// `count` interior knots that cut the total mass into equal shares; mass is spread evenly over each span.
/// \param breaks  mass.size() + 1 increasing values, 0 to 1
std::vector<double> equal_shares(std::span<const double> breaks, std::span<const double> mass, int count);

/// Sorts the knots and widens every span to at least `relative` times the mean span.
void widen_spans(std::vector<double>& knots, double relative);

/// 0, the knots, 1.
std::vector<double> with_ends(std::span<const double> knots);

/// `count` equally spaced knots in (0,1).
std::vector<double> uniform_knots(int count);

}  // namespace knotfit
