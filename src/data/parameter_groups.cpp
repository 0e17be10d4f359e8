#include "data/parameter_groups.h"

#include <algorithm>
#include <numeric>
namespace knotfit {

ParameterGroups group_by_parameter(std::span<const double> t) {
  ParameterGroups groups;
  groups.order.resize(t.size());
  std::iota(groups.order.begin(), groups.order.end(), Index{0});
  std::stable_sort(groups.order.begin(), groups.order.end(), [&](Index a, Index b) { return t[a] < t[b]; });
  for (Index i = 0; i < static_cast<Index>(t.size()); ++i)
    if (i == 0 || t[groups.order[i]] != t[groups.order[i - 1]]) groups.start.push_back(i);
  groups.start.push_back(static_cast<Index>(t.size()));
  return groups;
}

}  // namespace knotfit
