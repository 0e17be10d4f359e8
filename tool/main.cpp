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

int run(const CommandLine& line) {
  switch (line.command) {
    case Command::fit:
      return run_fit(line.fit);
    case Command::compare:
      return run_compare(line.compare);
    case Command::fit_curve:
      return run_fit_curve(line.fit_curve);
    case Command::parameterize:
      return run_parameterize(line.parameterize);
    case Command::eval:
      return run_eval(line.eval);
    case Command::distance:
      return run_distance(line.distance);
    case Command::info:
      return run_info(line.info);
    case Command::convert:
      return run_convert(line.convert);
    case Command::methods:
      return run_methods(line.list);
    case Command::formats:
      return run_formats(line.list);
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
