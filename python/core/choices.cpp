#include "choices.h"

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>

#include "bind.h"
#include "knotfit/exceptions.h"
#include "knotfit/place.h"
#include "tool/fit_run.h"
#include "tool/options_json.h"
namespace knotfit::python {
namespace {

namespace py = pybind11;

const tool::CommandRow& command_named(const std::string& name) {
  for (const tool::CommandRow& row : tool::command_rows())
    if (row.name == name) return row;
  throw InvalidInput("there is no command '" + name + "'");
}

py::list options_of(const std::string& name) {
  const tool::Command command = command_named(name).command;
  py::list rows;
  for (const tool::OptionRow* row : tool::rows_of(command)) {
    const tool::Use& use = *row->use_of(command);
    py::dict entry;
    entry["keyword"] = keyword_of(*row);
    entry["option"] = row->name();
    entry["key"] = row->key();
    entry["value"] = row->value_in(use);
    entry["help"] = use.help;
    entry["usual"] = row->stored.usual;
    entry["filled"] = row->stored.filled;
    entry["stored"] = row->stored.form != tool::Form::none;
    entry["output"] = row->acts.on_output.has_value();
    entry["repeats"] = row->repeats;
    rows.append(entry);
  }
  return rows;
}

}  // namespace

std::string keyword_of(const tool::OptionRow& row) {
  std::string name = row.name().substr(2);
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

tool::Arguments take_texts(tool::Command command, const Texts& texts, tool::Arguments arguments) {
  arguments.command = command;
  const std::vector<const tool::OptionRow*> rows = tool::rows_of(command);
  for (const auto& [keyword, text] : texts) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const tool::OptionRow* r) { return keyword_of(*r) == keyword; });
    if (row == rows.end()) throw InvalidInput(keyword + ": there is no such option");
    try {
      (*row)->holds.take(arguments, text);
      if (command != tool::Command::compare && !arguments.tolerances.empty())
        throw InvalidInput("'" + text + "' is several tolerances; a fit holds one");
    } catch (const InvalidInput& e) {
      throw InvalidInput(keyword + ": " + e.what());
    }
    arguments.choices.input.given.push_back((*row)->name());
  }
  return arguments;
}

tool::Arguments complete_texts(const Texts& texts, const std::string& stored, bool& default_tolerance) {
  tool::Arguments arguments = take_texts(tool::Command::fit, texts);
  if (!stored.empty()) tool::add_stored_options(arguments, stored);
  default_tolerance = tool::complete_choices(arguments);
  return arguments;
}

void bind_options(py::module_& m) {
  m.def("options", &options_of, py::arg("command"),
        "The options of a command of the tool, a dict each, from the rows that the command line is made of.");
  m.def(
      "methods",
      [] {
        py::list methods;
        for (const PlacementMethod& row : placement_methods()) {
          py::dict entry;
          entry["name"] = std::string(row.name);
          entry["summary"] = std::string(row.summary);
          entry["source"] = std::string(row.source);
          methods.append(entry);
        }
        return methods;
      },
      "Every placement method: name, summary, source.");
}

}  // namespace knotfit::python
