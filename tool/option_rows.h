// Every option once: a row says its names, what it takes, which commands have it, and what becomes of its value. The
// command line, stored options, --help, the man page and the completions of shells come from the rows.
#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "input_traits.h"
#include "knotfit/source_data.h"
#include "options.h"
#include "outputs.h"
namespace knotfit::tool {

/// A set of commands.
using Commands = unsigned;
constexpr Commands only(Command command) {
  return 1U << static_cast<unsigned>(command);
}
inline constexpr Commands kFit = only(Command::fit), kCompare = only(Command::compare),
                          kCurve = only(Command::fit_curve), kMap = only(Command::parameterize),
                          kEval = only(Command::eval), kDistance = only(Command::distance),
                          kInfo = only(Command::info), kConvert = only(Command::convert),
                          kLists = only(Command::methods) | only(Command::formats);
inline constexpr Commands kFits = kFit | kCompare | kCurve;
/// Those that read a file of data.
inline constexpr Commands kReads = kFits | kEval | kDistance | kInfo | kConvert;

struct Positional {
  std::string name, help;
  bool surface = false;  ///< a surface alone is read there
};

struct CommandRow {
  Command command;
  std::string name, summary;
  std::vector<Positional> inputs;
};
std::span<const CommandRow> command_rows();

/// Groups of the help, in its order.
inline constexpr std::string_view kGroups[] = {
    "What is compared", "Tolerance and size", "Knots",   "Input",          "Meshes", "Where", "What",
    "Output",           "CAD files",          "Running", "Repeating a fit"};

/// The option in some commands: its help there.
struct Use {
  Commands commands = 0;
  std::string_view group;
  std::string help;
  std::string value{};  ///< in place of the row's
};

/// How a value is kept. `print` gives the text that `take` reads back; nothing where none was given.
struct Holder {
  std::function<void(Arguments&, const std::string&)> take;
  std::function<std::optional<std::string>(const FitChoices&)> print{};
};

/// What a stored value is in JSON.
enum class Form {
  none,     ///< not stored
  text,     ///< a string
  words,    ///< a string that a command line quotes
  boolean,  ///< of a switch; --no-NAME undoes a stored one
  on_off,   ///< a boolean that a command line says as on or off
  whole,
  real,        ///< a number; a string where it is none, such as nan
  whole_pair,  ///< [3, 2] of 3x2; a string where it is none, such as auto
  real_pair,   ///< likewise
  names,       ///< ["x", "y"] of x,y
  wholes,      ///< [1, 2] of 1,2
  returns,     ///< likewise, last as -1
  measure,     ///< "max", "rms", "99%"
  knots        ///< a method's name, or {"u": [...], "v": [...]} of U;V
};

struct Stored {
  Form form = Form::none;
  std::string usual{};  ///< the default as `print` says it; a command line that repeats a fit leaves it out
  bool filled = false;  ///< the default is stored where nothing was given
  std::string key{};    ///< empty: the option's name
  std::function<void(Arguments&, const std::string&)> take{};  ///< in place of the holder's
};

/// What a shell offers for the value; lower-case words of `value` such as auto|off are offered without it.
enum class Offer { words, files, surfaces, methods, all_methods, formats };

/// Where the option acts; elsewhere it is refused by name.
struct Acts {
  bool (*on_input)(const InputTraits&) = nullptr;  ///< of fit and compare
  bool (*on_file)(const SourceData&) = nullptr;    ///< wherever data is read
  std::string_view purpose{};                      ///< "it repairs meshes"
  bool reading = false;                            ///< it says how data is read: of no use for a surface
  std::optional<OutputKind> on_output{};
  std::string_view outputs{};  ///< "STEP or IGES"
};

struct OptionRow {
  std::string names;    ///< "-o,--output"
  std::string value{};  ///< "X|X%"; empty: a switch
  std::vector<Use> uses{};
  Holder holds{};
  Commands first = 0;  ///< of those with a short help: whose --help shows it
  Stored stored{};
  Acts acts{};
  Offer offer = Offer::words;
  std::string words{};  ///< offered, in place of those of `value`
  bool repeats = false;
  Commands required = 0;
  std::vector<std::string> excludes{}, needs{};  ///< by name; of those that the command has
  std::string brief{};                           ///< for completions; empty: the help to its first stop
  std::string more{};                            ///< what the man page says after the help

  const Use* use_of(Command command) const;
  Commands commands() const;
  /// Every name with its dashes, the one that messages use last.
  std::vector<std::string> all_names() const;
  /// "--output": the first long one.
  std::string name() const;
  /// "output_format" of --output-format, unless `stored` has another.
  std::string key() const;
  const std::string& value_in(const Use& use) const { return use.value.empty() ? value : use.value; }
};

/// All rows: of stored options in the order of their JSON, of a help in its order within each group.
std::span<const OptionRow> option_rows();

/// The rows of a command in the order of its help.
std::vector<const OptionRow*> rows_of(Command command);

/// Commands whose --help shows some options and --help-all every one.
inline constexpr Commands kShortHelp = kFits;

// The parts of option_rows(), a file each.
void add_size_rows(std::vector<OptionRow>& rows);
void add_input_rows(std::vector<OptionRow>& rows);
void add_mesh_rows(std::vector<OptionRow>& rows);
void add_output_rows(std::vector<OptionRow>& rows);
void add_look_rows(std::vector<OptionRow>& rows);

}  // namespace knotfit::tool
