// Curves as knotfit JSON; the schema is in docs/formats.md.
#include <fmt/format.h>

#include <cmath>
#include <new>

#include "formats/file_bytes.h"
#include "formats/foreign.h"
#include "formats/json_document.h"
#include "formats/number.h"
#include "knotfit/curve_io.h"
#include "knotfit/exceptions.h"
#include "knotfit/version.h"
namespace knotfit {
namespace {

constexpr std::string_view kFormat = "knotfit-curve";
constexpr int kVersion = 1;

bool flag_of(const JsonMembers& in, std::string_view name) {
  return in.find(name) && in.at(name).boolean();
}

CurveDocument read_document(std::string_view text, const std::string& path) {
  const JsonMembers in(text, without_mark(text), path, "knotfit curve");
  check_format(in, kFormat);
  check_version(in, kVersion);
  JsonReader degree_reader = in.at("degree");
  const double degree = degree_reader.number();
  if (!(degree >= 1 && degree <= kMaxDegree) || degree != std::floor(degree))
    degree_reader.fail(fmt::format("a whole number from 1 to {} is needed", kMaxDegree));
  std::vector<double> knots, net;
  JsonReader knots_reader = in.at("knots");
  knots_reader.array([&](Index) { knots.push_back(knots_reader.number()); });
  JsonReader net_reader = in.at("control_points");
  Index dimension = 0;
  net_reader.array([&](Index i) {
    Index count = 0;
    net_reader.array([&](Index) {
      net.push_back(net_reader.number());
      ++count;
    });
    if (i == 0) dimension = count;
    if (count != dimension || count == 0)
      net_reader.fail(fmt::format("point {} has {} coordinates, the first {}", i, count, dimension));
  });
  if (dimension == 0) net_reader.fail("there are no points");
  CurveDocument document;
  try {
    document.curve = Curve(KnotVector(static_cast<int>(degree), std::move(knots)),
                           static_cast<int>(dimension), std::move(net));
  } catch (const InvalidInput& error) {
    in.at("knots").fail(error.what());
  }
  document.closed = flag_of(in, "closed");
  document.function = flag_of(in, "function");
  if (document.function) {
    document.x0 = in.at("x0").number();
    document.x1 = in.at("x1").number();
    if (dimension != 1)
      in.at("function").fail(fmt::format("a function has one component, not {}", dimension));
    if (!(document.x0 < document.x1)) in.at("x1").fail("x0 must be below x1");
  }
  document.options = object_of(in, "options");
  document.result = object_of(in, "result");
  return document;
}

}  // namespace

std::string to_json(const CurveDocument& document) {
  const Curve& c = document.curve;
  if (c.control_points().empty()) throw InvalidInput("a curve document without a curve cannot be written");
  if (document.function && (c.dimension() != 1 || !(document.x0 < document.x1)))
    throw InvalidInput("a function y over x needs one component and x0 below x1");
  std::string out = fmt::format(
      "{{\n  \"format\": \"{}\",\n  \"version\": {},\n  \"knotfit\": \"{}\",\n  \"degree\": {},\n  "
      "\"closed\": {},\n"
      "  \"function\": {},\n",
      kFormat, kVersion, version(), c.degree(), document.closed, document.function);
  if (document.function) {
    out += "  \"x0\": ";
    append_number(out, document.x0);
    out += ",\n  \"x1\": ";
    append_number(out, document.x1);
    out += ",\n";
  }
  out += "  \"knots\": ";
  append_numbers(out, c.knots().knots());
  append_object(out, "options", document.options, "curve");
  append_object(out, "result", document.result, "curve");
  out += ",\n  \"control_points\": [\n";
  const std::span<const double> net(c.control_points());
  for (Index i = 0; i < c.size(); ++i) {
    out += "    ";
    append_numbers(out, net.subspan(i * c.dimension(), c.dimension()));
    out += i + 1 < c.size() ? ",\n" : "\n";
  }
  return out + "  ]\n}\n";
}

CurveDocument curve_from_json(std::string_view text, const std::string& path) {
  try {
    return read_document(text, path);
  } catch (const std::bad_alloc&) {
    throw FileError(path, "reading it needs more memory than there is");
  }
}

CurveDocument read_curve(const std::string& path) {
  const FileBytes file = load_file(path);
  refuse_foreign(file);
  return curve_from_json(file.view(), path);
}

Curve curve_in_space(const CurveDocument& document) {
  const Curve& c = document.curve;
  if (c.dimension() > 3)
    throw InvalidInput(fmt::format("a curve of {} components is none in space", c.dimension()));
  if (c.dimension() == 3) return c;
  const std::vector<double> greville = c.knots().greville();
  std::vector<double> net;
  for (Index i = 0; i < c.size(); ++i) {
    const double* p = c.control_points().data() + i * c.dimension();
    if (c.dimension() == 2)
      net.insert(net.end(), {p[0], p[1], 0.0});
    else  // the Greville abscissae reproduce x
      net.insert(net.end(), {document.x0 + greville[i] * (document.x1 - document.x0), p[0], 0.0});
  }
  return Curve(c.knots(), 3, std::move(net));
}

}  // namespace knotfit
