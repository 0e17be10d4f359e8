// The commands: each does its work, prints its result and returns the exit status.
#pragma once
#include "options.h"
namespace knotfit::tool {

int run_fit(const Arguments& arguments);
int run_compare(const Arguments& arguments);
int run_fit_curve(const Arguments& arguments);
int run_parameterize(const Arguments& arguments);
int run_eval(const Arguments& arguments);
int run_distance(const Arguments& arguments);
int run_info(const Arguments& arguments);
int run_convert(const Arguments& arguments);
int run_methods(const Arguments& arguments);
int run_formats(const Arguments& arguments);

}  // namespace knotfit::tool
