#include "formats/surface_net.h"

#include <fmt/format.h>

#include <algorithm>
namespace knotfit {
namespace {

constexpr Index kMostComponents = 1000;

/// How many arrays open before the first value.
int depth_of(std::string_view value) {
  int depth = 0;
  for (const char c : value) {
    if (c == '[')
      ++depth;
    else if (c != ' ' && c != '\t' && c != '\n' && c != '\r')
      break;
  }
  return depth;
}

Index count_elements(JsonReader reader) {
  Index count = 0;
  reader.array([&](Index k) {
    reader.skip();
    count = k + 1;
  });
  return count;
}

/// [rows][columns][dimension]
ControlNet read_nested(JsonReader& reader, Index size_u, Index size_v, const char* knots_u,
                       const char* knots_v) {
  ControlNet net;
  Index rows = 0, dimension = 0;
  reader.array([&](Index i) {
    if (i >= size_u)
      reader.fail(fmt::format("more than the {} rows that degree and {} ask for", size_u, knots_u));
    Index columns = 0;
    reader.array([&](Index j) {
      if (j >= size_v)
        reader.fail(fmt::format("row {} (from 0) has more than the {} points that degree and {} ask for", i,
                                size_v, knots_v));
      Index components = 0;
      reader.array([&](Index) {
        net.points.push_back(reader.number());
        ++components;
      });
      if (i == 0 && j == 0) dimension = components;
      if (components != dimension || dimension == 0 || dimension > kMostComponents)
        reader.fail(fmt::format("point ({}, {}) has {} components, the first point has {}", i, j, components,
                                dimension));
      columns = j + 1;
    });
    if (columns != size_v)
      reader.fail(fmt::format("row {} (from 0) has {} points, but degree and {} ask for {}", i, columns,
                              knots_v, size_v));
    rows = i + 1;
  });
  if (rows != size_u)
    reader.fail(fmt::format("{} rows, but degree and {} ask for {}", rows, knots_u, size_u));
  net.dimension = static_cast<int>(dimension);
  return net;
}

/// A list of points, or of rows of numbers, all of one length.
ControlNet read_list_of_lists(JsonReader& reader, Index size_u, Index size_v) {
  ControlNet net;
  Index rows = 0, columns = 0;
  reader.array([&](Index i) {
    Index count = 0;
    reader.array([&](Index) {
      net.points.push_back(reader.number());
      ++count;
    });
    if (i == 0) columns = count;
    if (count != columns)
      reader.fail(fmt::format("entry {} (from 0) has {} numbers, the first has {}", i, count, columns));
    rows = i + 1;
  });
  Index dimension = 0;
  if (rows == size_u * size_v)
    dimension = columns;
  else if (rows == size_u && columns % size_v == 0)
    dimension = columns / size_v;
  if (dimension == 0 || dimension > kMostComponents)
    reader.fail(
        fmt::format("{} entries of {} numbers are no {} x {} control points, which degree and knots ask for",
                    rows, columns, size_u, size_v));
  net.dimension = static_cast<int>(dimension);
  return net;
}

ControlNet read_flat(JsonReader& reader, Index size_u, Index size_v) {
  ControlNet net;
  reader.array([&](Index) { net.points.push_back(reader.number()); });
  const Index count = static_cast<Index>(net.points.size()), points = size_u * size_v;
  if (count == 0 || count % points != 0 || count / points > kMostComponents)
    reader.fail(fmt::format("{} numbers are no {} x {} control points, which degree and knots ask for", count,
                            size_u, size_v));
  net.dimension = static_cast<int>(count / points);
  return net;
}

/// From v slowest to u slowest.
void exchange(ControlNet& net, Index size_u, Index size_v) {
  const Index d = net.dimension;
  std::vector<double> points(net.points.size());
  for (Index i = 0; i < size_u; ++i)
    for (Index j = 0; j < size_v; ++j)
      std::copy_n(net.points.begin() + (j * size_u + i) * d, d, points.begin() + (i * size_v + j) * d);
  net.points = std::move(points);
}

}  // namespace

ControlNet read_control_net(JsonReader reader, std::string_view value, Index size_u, Index size_v,
                            bool v_major) {
  const int depth = depth_of(value);
  if (depth == 3) {
    // A nested net says by its shape how it lies, unless it is square: then u is outside.
    const bool exchanged = v_major && size_u != size_v && count_elements(reader) == size_v;
    if (!exchanged) return read_nested(reader, size_u, size_v, "knots_u", "knots_v");
    ControlNet net = read_nested(reader, size_v, size_u, "knots_v", "knots_u");
    exchange(net, size_u, size_v);
    return net;
  }
  const Index outer = v_major ? size_v : size_u, inner = v_major ? size_u : size_v;
  ControlNet net = depth == 2 ? read_list_of_lists(reader, outer, inner) : read_flat(reader, outer, inner);
  if (v_major) exchange(net, size_u, size_v);
  return net;
}

}  // namespace knotfit
