// VTK XML structured grid (.vts), arrays in base64: an XML file that any reader takes.
#include <fmt/format.h>

#include <bit>
#include <cstring>
#include <ostream>
#include <string>

#include "knotfit/mesh_io.h"
namespace knotfit {
namespace {

constexpr const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Base64 of bytes that come in parts [RFC 4648].
class Base64 {
 public:
  explicit Base64(std::ostream& out) : out_(out) {}
  void put(const void* data, std::size_t size) {
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t k = 0; k < size; ++k) {
      group_ = group_ << 8 | bytes[k];
      if (++held_ == 3) write(4);
    }
  }
  void finish() {
    if (held_ > 0) {
      const int digits = held_ + 1;
      group_ <<= 8 * (3 - held_);
      write(digits);
    }
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

 private:
  void write(int digits) {
    for (int k = 0; k < 4; ++k) text_ += k < digits ? kDigits[group_ >> (18 - 6 * k) & 63] : '=';
    group_ = 0;
    held_ = 0;
    if (text_.size() < 1 << 16) return;
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }
  std::ostream& out_;
  std::string text_;
  unsigned group_ = 0;
  int held_ = 0;
};

/// \param at  component d of point (i, j); VTK's first index runs fastest, so that u does
template <class At>
void array(std::ostream& out, const Tessellation& t, const char* name, int components, const At& at) {
  out << fmt::format("<DataArray type=\"Float64\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">",
                     name, components);
  // Header and data are one stream of base64.
  Base64 text(out);
  const std::uint64_t bytes = 8 * t.u.size() * t.v.size() * static_cast<std::size_t>(components);
  text.put(&bytes, sizeof bytes);
  for (std::size_t j = 0; j < t.v.size(); ++j)
    for (std::size_t i = 0; i < t.u.size(); ++i)
      for (int d = 0; d < components; ++d) {
        const double value = at(i, j, d);
        text.put(&value, sizeof value);
      }
  text.finish();
  out << "</DataArray>\n";
}

}  // namespace

void write_vts(std::ostream& out, const Tessellation& t) {
  const std::string extent = fmt::format("0 {} 0 {} 0 0", t.u.size() - 1, t.v.size() - 1);
  out << fmt::format(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"StructuredGrid\" version=\"1.0\" byte_order=\"{}\" "
      "header_type=\"UInt64\">\n<StructuredGrid WholeExtent=\"{}\">\n<Piece Extent=\"{}\">\n",
      std::endian::native == std::endian::big ? "BigEndian" : "LittleEndian", extent, extent);
  const std::size_t columns = t.v.size();
  const auto scalar = [&](const std::vector<double>& values) {
    return [&values, columns](std::size_t i, std::size_t j, int) { return values[i * columns + j]; };
  };
  const auto vector = [&](const std::vector<double>& values) {
    return [&values, columns](std::size_t i, std::size_t j, int d) {
      return values[3 * (i * columns + j) + static_cast<std::size_t>(d)];
    };
  };
  out << fmt::format("<PointData{} Normals=\"normal\">\n", t.error.empty() ? "" : " Scalars=\"error\"");
  if (!t.error.empty()) array(out, t, "error", 1, scalar(t.error));
  array(out, t, "normal", 3, vector(t.normals));
  array(out, t, "mean_curvature", 1, scalar(t.mean_curvature));
  array(out, t, "gaussian_curvature", 1, scalar(t.gaussian_curvature));
  array(out, t, "uv", 2, [&](std::size_t i, std::size_t j, int d) {
    return t.map.from_uv(t.u[i], t.v[j])[static_cast<std::size_t>(d)];
  });
  out << "</PointData>\n<Points>\n";
  array(out, t, "points", 3, vector(t.points));
  out << "</Points>\n</Piece>\n</StructuredGrid>\n</VTKFile>\n";
}

}  // namespace knotfit
