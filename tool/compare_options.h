// What a comparison is asked for, as the library's options.
#pragma once
#include "knotfit/compare.h"
#include "options.h"
namespace knotfit::tool {

/// FitOptions::user_features stands for a feature file until the data is read.
CompareOptions compare_options(const Arguments& arguments);

}  // namespace knotfit::tool
