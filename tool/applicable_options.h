// Options that an input or the outputs leave without any effect are refused by name. Only what stands on the command
// line counts (InputOptions::given): what --options repeats is used where it applies.
#pragma once
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "knotfit/source_data.h"
#include "options.h"
#include "outputs.h"
namespace knotfit::tool {

/// What holds for every command that reads data: --columns of files whose columns have names of their own.
/// \throws InvalidInput  names the option, what the input is, and what the option is for
void refuse_idle_reading(const SourceData& data, const std::string& path, const InputOptions& options);

/// Options of fit and compare by what the input is and how it is parameterized: --base of a mesh, --spacing of a raster.
/// \throws InvalidInput  as above
void refuse_idle_options(const SourceData& data, const FitChoices& choices);

/// Options on outputs of a kind that is not asked for: --cell without an .asc.
/// \throws InvalidInput  names the option and the outputs it is for
void refuse_idle_output_options(const std::vector<std::string>& given, const std::vector<OutputFile>& files);

/// \throws InvalidInput  one of `options` is given: "OPTION does not apply to WHAT"
void refuse_given(const std::vector<std::string>& given, std::initializer_list<std::string_view> options,
                  const std::string& what);

/// The options that say how data is read: of no use where a surface is read.
/// \throws InvalidInput  as refuse_given
void refuse_data_options(const std::vector<std::string>& given, const std::string& what);

bool is_given(const std::vector<std::string>& given, std::string_view option);

}  // namespace knotfit::tool
