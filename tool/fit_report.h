// What a fit tells its user: as JSON and as text.
#pragma once
#include <string>
#include <vector>

#include "input.h"
#include "knotfit/fit_mesh.h"
#include "knotfit/fit_surface.h"
#include "options.h"
namespace knotfit::tool {

struct FitReport {
  const FitResult& result;
  const FitInput& input;
  const FitChoices& choices;           ///< completed
  const MeshFit* corrected = nullptr;  ///< null: the parameters were taken as they are
  bool default_tolerance = false;      ///< no tolerance, size or knots were given
  double seconds = 0;
  long long peak_memory_bytes = 0;
  std::vector<std::string> outputs{};  ///< files written
  std::string call{};                  ///< what made it, under a picture; empty: the command line
};

/// The object of --json, as text.
std::string report_to_json(const FitReport& report);

/// What a surface file says of its making: no times, no memory, nothing that a second run changes.
std::string stored_result(const FitReport& report);

/// The summary on standard output.
std::string report_to_text(const FitReport& report);

/// Share of the points whose error is at most the tolerance.
double share_within(const FitResult& result);

/// The verdict in a few words, for a picture: "1% at every point: reached".
std::string verdict(const FitReport& report);

/// Largest resident memory of this process so far, in bytes.
long long peak_memory_bytes();

}  // namespace knotfit::tool
