// The commands: each does its work, prints its result and returns the exit status.
#pragma once
#include "options.h"
namespace knotfit::tool {

int run_fit(const FitArguments& arguments);
int run_compare(const CompareArguments& arguments);
int run_fit_curve(const CurveArguments& arguments);
int run_parameterize(const ParameterizeArguments& arguments);
int run_eval(const EvalArguments& arguments);
int run_distance(const DistanceArguments& arguments);
int run_info(const InfoArguments& arguments);
int run_convert(const ConvertArguments& arguments);
int run_methods(const ListArguments& arguments);
int run_formats(const ListArguments& arguments);

}  // namespace knotfit::tool
