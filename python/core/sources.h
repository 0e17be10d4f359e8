// Data on its way to a fit: arrays as what a reader would have given, or a file.
#pragma once
#include <memory>
#include <string>
#include <variant>

#include "knotfit/points.h"
#include "knotfit/source_data.h"
#include "tool/input.h"
namespace knotfit::python {

/// What is fitted. A fit may take it: it is used once.
struct Source {
  std::variant<SourceData, ParameterizedPoints, std::string> content;
  Index rows = 0;  ///< of the caller's array; 0: a file
};

/// \throws InvalidInput, FileError
tool::FitInput input_of(Source& source, const tool::FitChoices& choices, const Control& control);

/// The name of what comes from memory, where a file's path stands.
inline const std::string kArrays = "arrays";

}  // namespace knotfit::python
