// LAS, the points of laser scanners [ASPRS LAS 1.4-R15]: versions 1.0 to 1.4, not compressed.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "formats/binary_number.h"
#include "formats/mesh_builder.h"
#include "formats/missing.h"
#include "formats/readers.h"
#include "knotfit/exceptions.h"
namespace knotfit {
namespace {

// Bytes of a record of each point data format; user's own bytes may follow.
constexpr std::size_t kRecord[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
constexpr int kExtended = 6;  // formats from here on have 4 bits a return and 8 a class
constexpr std::size_t kLeastHeader = 227, kHeaderOf14 = 375;

class Header {
 public:
  explicit Header(const FileBytes& file) : file_(file), bytes_(file.view()) {
    if (!bytes_.starts_with("LASF")) {
      const std::string kind = foreign_kind(bytes_);
      fail(fmt::format("is not a LAS file: it does not begin with LASF{}",
                       kind.empty() ? "" : " but like " + kind));
    }
    if (bytes_.size() < kLeastHeader)
      fail(fmt::format("ends at byte {}, inside its header: it is cut off", bytes_.size()));
    const int major = byte(24), minor = byte(25);
    if (major != 1 || minor > 4)
      fail(fmt::format("is LAS {}.{}; versions 1.0 to 1.4 are read", major, minor));
    check_format(byte(104));
    length = static_cast<std::size_t>(number({'u', 2}, 105));
    if (length < kRecord[format])
      fail(fmt::format("point format {} takes {} bytes a point, but the header says {}", format,
                       kRecord[format], length));
    offset = static_cast<std::size_t>(number({'u', 4}, 96));
    if (offset < kLeastHeader)
      fail(fmt::format("the header says that the points begin at byte {}, inside the header", offset));
    count = claimed(minor);
    more = unclaimed(minor);
    check_count();
    for (int c = 0; c < 3; ++c) {
      scale[c] = number({'f', 8}, 131 + 8 * static_cast<std::size_t>(c));
      origin[c] = number({'f', 8}, 155 + 8 * static_cast<std::size_t>(c));
      if (!(std::abs(scale[c]) > 0) || !std::isfinite(scale[c]) || !std::isfinite(origin[c]))
        fail(fmt::format("the scale or the offset of {} is no number to count by: {}, {}", "xyz"[c], scale[c],
                         origin[c]));
    }
  }

  int format = 0;
  std::size_t length = 0, offset = 0, count = 0;
  std::size_t more = 0;  ///< points that there is room for behind those claimed
  double scale[3], origin[3];

 private:
  [[noreturn]] void fail(const std::string& message) const { throw FileError(file_.path(), message); }
  int byte(std::size_t at) const { return static_cast<unsigned char>(bytes_[at]); }
  double number(NumberType type, std::size_t at) const {
    return number_loader(type, false)(bytes_.data() + at);
  }

  void check_format(int stored) {
    if (stored > 10) fail(fmt::format("has points of format {}; there are 0 to 10", stored));
    format = stored;
  }

  /// The number of points; 1.4 counts in 64 bits where the old field is not enough.
  std::size_t claimed(int minor) const {
    const double old = number({'u', 4}, 107);
    if (minor < 4) return static_cast<std::size_t>(old);
    if (bytes_.size() < kHeaderOf14)
      fail(fmt::format("ends at byte {}, inside its header: it is cut off", bytes_.size()));
    const double wide = number({'u', 8}, 247);
    return static_cast<std::size_t>(std::min(wide > 0 ? wide : old, 9e18));
  }

  /// Whole records between the last point and what else the header names: records of 1.4, waveforms of 1.3.
  std::size_t unclaimed(int minor) const {
    double end = static_cast<double>(bytes_.size());
    const double points =
        static_cast<double>(offset) + static_cast<double>(count) * static_cast<double>(length);
    const auto ends_at = [&](std::size_t at) {
      const double start = number({'u', 8}, at);
      if (start >= points) end = std::min(end, start);
    };
    if (minor >= 3 && std::min(offset, bytes_.size()) >= 235 && number({'u', 8}, 227) > 0) ends_at(227);
    if (minor >= 4 && number({'u', 4}, 243) > 0) ends_at(235);
    return end > points ? static_cast<std::size_t>((end - points) / static_cast<double>(length)) : 0;
  }

  void check_count() const {
    const std::size_t left = bytes_.size() - std::min(offset, bytes_.size());
    if (count > left / length)
      fail(fmt::format(
          "the header claims {} points of {} bytes, but only {} bytes follow (room for {}); it is "
          "cut off",
          count, length, left, left / length));
    if (count == 0)
      fail(more == 0
               ? "the header claims 0 points"
               : fmt::format("the header claims 0 points, but {} follow: the file was not finished; lasinfo "
                             "-repair_counters (LAStools) counts them",
                             more));
  }

  const FileBytes& file_;
  std::string_view bytes_;
};

/// What tells a point's kind.
struct Kind {
  int number = 0, returns = 0, of_class = 0;
  bool withheld = false;
};

Kind kind_of(const char* record, int format) {
  const auto bits = [record](int at, int shift, int mask) {
    return static_cast<unsigned char>(record[at]) >> shift & mask;
  };
  if (format < kExtended) return {bits(14, 0, 7), bits(14, 3, 7), bits(15, 0, 31), bits(15, 7, 1) != 0};
  return {bits(14, 0, 15), bits(14, 4, 15), bits(16, 0, 255), bits(15, 2, 1) != 0};
}

bool wanted(const Kind& kind, const ReadOptions& options) {
  const auto has = [](const std::vector<int>& list, int value) {
    return std::find(list.begin(), list.end(), value) != list.end();
  };
  if (!options.classes.empty() && !has(options.classes, kind.of_class)) return false;
  return options.returns.empty() || has(options.returns, kind.number) ||
         (kind.number == kind.returns && has(options.returns, kLastReturn));
}

std::string_view name_of_class(int of_class) {
  constexpr std::string_view names[] = {
      "never classified", "unclassified", "ground",    "low vegetation", "medium vegetation",
      "high vegetation",  "building",     "low noise", "key points",     "water"};
  return of_class < 10 ? names[of_class] : std::string_view();
}

/// What a point of a format holds: all but its place is left out, once classes and returns have chosen.
std::vector<std::string> columns_of(int format) {
  std::vector<std::string> columns = {"x", "y", "z", "intensity", "return", "class"};
  if (format == 1 || format >= 3) columns.emplace_back("time");
  if (format == 2 || format == 3 || format == 5 || format == 7 || format == 8 || format == 10)
    columns.insert(columns.end(), {"r", "g", "b"});
  return columns;
}

/// `value` where rounding of the file's whole numbers alone parts it from the nodata value.
double stored_value(double value, double nodata, double scale) {
  return std::abs(value - nodata) <= 0.5 * std::abs(scale) ? nodata : value;
}

/// "1 unclassified (83893), 2 ground (26107)".
std::string list_of(const std::map<int, std::size_t>& counts, bool classes) {
  std::string out;
  for (const auto& [key, count] : counts) {
    const std::string_view name = classes ? name_of_class(key) : std::string_view();
    out += fmt::format("{}{}{}{} ({})", out.empty() ? "" : ", ", key, name.empty() ? "" : " ", name, count);
  }
  return out;
}

}  // namespace

SourceData read_las(const FileBytes& file, const ReadOptions& options) {
  const Header header(file);
  check_claim(file, static_cast<Index>(header.count), "points", 0, 0);
  const char* const first = file.view().data() + header.offset;
  std::map<int, std::size_t> classes, returns;
  std::size_t withheld = 0, kept = 0;
  for (std::size_t k = 0; k < header.count; ++k) {
    const Kind kind = kind_of(first + k * header.length, header.format);
    if (kind.withheld) ++withheld;
    if (kind.withheld) continue;
    ++classes[kind.of_class], ++returns[kind.number];
    kept += wanted(kind, options);
  }
  if (kept == 0)
    throw FileError(
        file.path(),
        withheld == header.count
            ? fmt::format("all {} points are marked as withheld", withheld)
            : fmt::format("no point is of the classes and returns asked for; there are the classes "
                          "{}; the returns {}",
                          list_of(classes, true), list_of(returns, false)));
  SourceData data{file.path(), "las", PointTable{}};
  auto& table = std::get<PointTable>(data.content);
  std::vector<double>* columns[] = {&table.x, &table.y, &table.z};
  for (auto* column : columns) column->reserve(kept);
  const bool number_points = kept < header.count || options.nodata;
  if (number_points) table.line.reserve(kept);
  const LoadNumber load = number_loader({'i', 4}, false);
  for (std::size_t k = 0; k < header.count; ++k) {
    const char* const record = first + k * header.length;
    const Kind kind = kind_of(record, header.format);
    if (kind.withheld || !wanted(kind, options)) continue;
    for (int c = 0; c < 3; ++c) {
      const double x = load(record + 4 * c) * header.scale[c] + header.origin[c];
      if (!std::isfinite(x))
        throw FileError(file.path(), fmt::format("point {} (from 1): {} is not finite", k + 1, "xyz"[c]));
      columns[c]->push_back(x);
    }
    if (number_points) table.line.push_back(static_cast<Index>(k) + 1);
  }
  std::vector<Index> missing;
  if (options.nodata)
    for (Index k = 0; k < table.size(); ++k)
      if (misses_value(stored_value(table.z[k], *options.nodata, header.scale[2]), true, options.nodata))
        missing.push_back(k);
  drop_points(table, missing);
  data.left_out = static_cast<Index>(missing.size()) + drop_far_nodata(table, options.nodata);
  if (table.z.empty()) throw FileError(file.path(), "every point has the nodata value");
  data.columns = columns_of(header.format);
  data.columns_from = "header";
  data.notes.push_back("classes: " + list_of(classes, true));
  data.notes.push_back("returns: " + list_of(returns, false));
  if (withheld > 0) data.notes.push_back(fmt::format("{} points marked as withheld are left out", withheld));
  if (data.left_out > 0) data.notes.push_back(left_out_note(data.left_out, *options.nodata));
  if (header.more > 0)
    data.notes.push_back(
        fmt::format("the header claims {} points, which are read, but {} more follow them: was the "
                    "file finished? lasinfo -repair_counters (LAStools) counts them",
                    header.count, header.more));
  return data;
}

}  // namespace knotfit
