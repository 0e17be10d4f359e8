// knotfit: the command-line tool. Standard output is the result only; messages go to standard error.
#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>

#include "command_line.h"
#include "commands.h"
#include "exit_status.h"
#include "knotfit/exceptions.h"
#include "outputs.h"
#include "remedy_words.h"
namespace {

using namespace knotfit;
using namespace knotfit::tool;

int run(const Arguments& arguments) {
  switch (arguments.command) {
    case Command::fit:
      return run_fit(arguments);
    case Command::compare:
      return run_compare(arguments);
    case Command::fit_curve:
      return run_fit_curve(arguments);
    case Command::parameterize:
      return run_parameterize(arguments);
    case Command::eval:
      return run_eval(arguments);
    case Command::distance:
      return run_distance(arguments);
    case Command::info:
      return run_info(arguments);
    case Command::convert:
      return run_convert(arguments);
    case Command::methods:
      return run_methods(arguments);
    case Command::formats:
      return run_formats(arguments);
  }
  return kOther;
}

int fail(int status, const std::string& message) {
  std::fprintf(stderr, "knotfit: %s\n", in_tool_words(message).c_str());
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  // A file size limit is a write that fails, not a crash.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    const ParsedCommandLine parsed = parse_command_line(argc, argv);
    if (!parsed.run) {
      print(parsed.text);
      return kReached;
    }
    return run(*parsed.run);
  } catch (const UsageError& e) {
    return fail(kBadInput, e.what());
  } catch (const InvalidInput& e) {
    return fail(kBadInput, e.what());
  } catch (const FileError& e) {
    return fail(kBadInput, e.what());
  } catch (const WriteError& e) {
    return fail(kOther, e.what());
  } catch (const std::bad_alloc&) {
    return fail(kOther, "there is not enough memory for this");
  } catch (const std::exception& e) {
    return fail(kOther, std::string("internal error: ") + e.what());
  }
}
