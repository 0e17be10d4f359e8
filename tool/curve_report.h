// What a fit of a curve tells its user, and its files.
#pragma once
#include <string>
#include <vector>

#include "knotfit/curve_io.h"
#include "knotfit/curve_points.h"
#include "knotfit/fit_curve.h"
#include "options.h"
#include "outputs.h"
#include "reading.h"
namespace knotfit::tool {

struct CurveReport {
  const CurveFitResult& result;
  const CurvePoints& points;
  const Arguments& arguments;
  const Reading& reading;
  double seconds = 0;
  std::vector<std::string> outputs{};  ///< files written
};

/// The curve, and how it is meant.
CurveDocument document_of(const CurveFitResult& result, const CurvePoints& points);

/// The object of --json, as text.
std::string curve_to_json(const CurveReport& report);
/// The summary on standard output.
std::string curve_to_text(const CurveReport& report);

/// Before long work. \throws InvalidInput  an output that holds no curve
void check_curve_output(const OutputFile& file);
void write_curve_output(const OutputFile& file, const CurveReport& report);

/// A row of --compare.
struct CurveRow {
  std::string method;
  std::string failure;  ///< empty: fitted
  CurveFitResult result;
  double seconds = 0;
};
std::string curve_table(const std::vector<CurveRow>& rows);
std::string curve_rows_json(const std::vector<CurveRow>& rows, const Arguments& arguments,
                            const Reading& reading, bool stopped);

}  // namespace knotfit::tool
