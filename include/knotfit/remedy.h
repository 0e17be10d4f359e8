// What mends a mistake, by name. A text of the library names a remedy in backquotes, `fill_holes` or `nodata = nan`, as
// its fields and arguments are named; a program whose options have other names says theirs instead:
//
//   catch (const InvalidInput& e) {
//     std::cerr << say_remedies(e.what(), [](const NamedRemedy& r) { return my_option(r.remedy, r.value); });
//   }
#pragma once
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>
namespace [[gnu::visibility("default")]] knotfit {

enum class Remedy {
  format,           ///< ReadOptions::format: name the format of a file
  columns,          ///< ReadOptions::columns: say what each column is
  nodata,           ///< ReadOptions::nodata: leave out what misses a value; NaN: by every word for it
  skip_lines,       ///< ReadOptions::skip_lines: leave out the first lines of a text
  block,            ///< ReadOptions::block: choose one of several blocks of points
  classes,          ///< ReadOptions::classes, of LAS files
  returns,          ///< ReadOptions::returns, of LAS files
  height_field,     ///< parameterize_height_field(): fit z over x, y
  rescale,          ///< parameterize_given(): map the range of u and v to [0,1]
  duplicates,       ///< DuplicateRule: merge points with equal parameters, or keep one
  base,             ///< CloudOptions::base: what a cloud is projected to
  fill_holes,       ///< MeshRepair::fill_holes, CloudOptions::fill_holes
  largest_part,     ///< MeshRepair::largest_part
  orient,           ///< MeshRepair::orient
  drop_degenerate,  ///< MeshRepair::drop_degenerate
  vertices,         ///< Mesh::vertices, given to parameterize_cloud(): points in place of a mesh
  degree,           ///< degree_u, degree_v, degree
  smoothing,        ///< the smoothing floor of least squares
  correct,          ///< correction of parameters with a surface: fit_mesh()
  corrections,      ///< CurveFitOptions::corrections
  closed,           ///< CurvePoints::closed
  force             ///< replace a file that exists
};
inline constexpr Remedy kLastRemedy = Remedy::force;
/// Every one, in order.
std::span<const Remedy> all_remedies();
/// "fill_holes".
std::string_view remedy_name(Remedy remedy);

/// A remedy that a text names, and the value that it asks for.
struct NamedRemedy {
  Remedy remedy = Remedy::format;
  std::string value;  ///< "cylinder"; empty: none is said
  bool operator==(const NamedRemedy&) const = default;
};

/// "`fill_holes`", "`base = cylinder`": how every text of the library names a remedy.
std::string remedy_text(Remedy remedy, std::string_view value = {});
/// The remedies that a text names, in its order.
std::vector<NamedRemedy> remedies_in(std::string_view text);
/// The text with every remedy as `say` says it.
std::string say_remedies(std::string_view text, const std::function<std::string(const NamedRemedy&)>& say);

}  // namespace knotfit
