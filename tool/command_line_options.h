// Options as CLI11 takes them: what the files of the command line share. They include CLI11 themselves.
#pragma once
#include <functional>
#include <optional>
#include <string>

#include "options.h"
namespace CLI {
class App;
class Option;
}  // namespace CLI
namespace knotfit::tool {

inline constexpr std::size_t kDescription = 70;  ///< width of descriptions

/// One option of one command, its value given to `take`; what `take` refuses is named by the option.
CLI::Option* add(CLI::App& app, const std::string& name, const std::string& value, const std::string& help,
                 const std::string& group, const std::function<void(const std::string&)>& take);
CLI::Option* add_flag(CLI::App& app, const std::string& name, const std::string& help,
                      const std::string& group, const std::function<void()>& take);
CLI::Option* add_input(CLI::App& app, const std::string& name, std::string& path, const std::string& help);

// Options of several commands.
void add_input_options(CLI::App& app, InputOptions& input);
CLI::Option* add_output_options(CLI::App& app, OutputOptions& output, const std::string& what);
void add_surface_options(CLI::App& app, SurfaceChoices& source);
void add_force(CLI::App& app, bool& force, const std::string& help);
void add_quiet(CLI::App& app, bool& quiet, const std::string& help);
void add_threads(CLI::App& app, int& threads);
void add_feature_file(CLI::App& app, FitChoices& c, const std::string& group);
void add_data_options(CLI::App& app, FitChoices& choices);
void add_weld(CLI::App& app, InputOptions& input);
void add_mesh_options(CLI::App& app, FitChoices& choices);
void add_evaluations(CLI::App& app, FitChoices& choices, const std::string& group);
void add_cad_options(CLI::App& app, CadChoices& cad, const std::string& unit);
void add_unit(CLI::App& app, std::optional<CadUnit>& unit, const std::string& help, const std::string& group);

// The options of each command. A new one is shown by `knotfit COMMAND --help-all`; kShort in command_line_help.cpp
// names those that `--help` shows too.
void add_fit(CLI::App& app, FitArguments& fit);
void add_parameterize(CLI::App& app, ParameterizeArguments& parameterize);
void add_eval(CLI::App& app, EvalArguments& eval);
void add_info(CLI::App& app, InfoArguments& info);
void add_convert(CLI::App& app, ConvertArguments& convert);
void add_list(CLI::App& app, ListArguments& list);
void add_compare(CLI::App& app, CompareArguments& compare);
void add_distance(CLI::App& app, DistanceArguments& distance);
void add_fit_curve(CLI::App& app, CurveArguments& curve);

}  // namespace knotfit::tool
