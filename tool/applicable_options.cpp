#include "applicable_options.h"

#include <fmt/format.h>

#include <algorithm>

#include "knotfit/exceptions.h"
#include "option_rows.h"
#include "standard_streams.h"
namespace knotfit::tool {

bool is_given(const std::vector<std::string>& given, std::string_view option) {
  return std::find(given.begin(), given.end(), option) != given.end();
}

void refuse_given(const std::vector<std::string>& given, std::initializer_list<std::string_view> options,
                  const std::string& what) {
  for (const std::string_view option : options)
    if (is_given(given, option)) throw InvalidInput(fmt::format("{} does not apply to {}", option, what));
}

void refuse_data_options(const std::vector<std::string>& given, const std::string& what) {
  for (const OptionRow& row : option_rows())
    if (row.acts.reading) refuse_given(given, {row.name()}, what);
}

void refuse_idle_reading(const SourceData& data, const std::string& path, const InputOptions& options) {
  const std::string what = std::holds_alternative<Raster>(data.content)
                               ? "a raster of heights"
                               : fmt::format("a file of format {}", data.format);
  for (const OptionRow& row : option_rows())
    if (row.acts.on_file && is_given(options.given, row.name()) && !row.acts.on_file(data))
      throw InvalidInput(fmt::format("{}: {} does not apply to {}: {}", input_name(path), row.name(), what,
                                     row.acts.purpose));
}

void refuse_idle_options(const SourceData& data, const FitChoices& choices) {
  const InputTraits input = input_traits(data, choices);
  for (const OptionRow& row : option_rows())
    if (row.acts.on_input && is_given(choices.input.given, row.name()) && !row.acts.on_input(input))
      throw InvalidInput(
          fmt::format("{} does not apply to {}: {}", row.name(), input.name(), row.acts.purpose));
}

void refuse_idle_output_options(const std::vector<std::string>& given, const std::vector<OutputFile>& files) {
  for (const OptionRow& row : option_rows())
    if (row.acts.on_output && is_given(given, row.name()) && !asks_for(files, *row.acts.on_output))
      throw InvalidInput(
          fmt::format("{} is for {} outputs (-o), and none is asked for", row.name(), row.acts.outputs));
}

}  // namespace knotfit::tool
