#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <new>

#include "app/cli/command.h"
#include "app/cli/interrupt.h"
#include "app/cli/terminal_progress.h"
#include "app/document/invocation.h"

namespace stipple {
namespace {

int fail(ExitCode code, std::string sentence) {
  std::ranges::replace_if(
      sentence, [](char c) { return c == '\n' || c == '\r'; }, ' ');
  while (sentence.ends_with(' ')) sentence.pop_back();
  fmt::print(stderr, "stipple-cli: {}\n", sentence);
  return code;
}

// What the user must see on stdout is lost where it is full or closed.
void print(const std::string& text) {
  const bool written = std::fwrite(text.data(), 1, text.size(), stdout) == text.size();
  if (std::fflush(stdout) != 0 || !written) throw CommandFailure(kFile, "the output cannot be written");
}

int perform(const Command& command) {
  catchInterrupts();
  TerminalProgress progress;
  const auto failing = [&](ExitCode code, const char* sentence) {
    progress.clear();
    return fail(code, sentence);
  };
  try {
    const Outcome outcome = command(progress);
    progress.clear();
    print(outcome.text);
    for (const std::string& warning : outcome.warnings)
      fmt::print(stderr, "stipple-cli: warning: {}\n", warning);
    return kDone;
  } catch (const CommandFailure& failure) {
    return failing(failure.code(), failure.what());
  } catch (const UsageError& error) {
    return failing(kUsage, error.what());
  } catch (const Cancelled&) {
    return failing(kInterrupted, "interrupted");
  } catch (const IoError& error) {
    return failing(kFile, error.what());
  } catch (const std::bad_alloc&) {
    return failing(kFailed, "out of memory");
  } catch (const std::exception& error) {
    return failing(kFailed, error.what());
  }
}

// Says what is wrong with a first word that is neither a command nor an option of the program.
void checkFirstWord(const CLI::App& program, const std::string& word) {
  if (word.starts_with('-')) {
    if (program.get_option_no_throw(word)) return;
    throw CommandFailure(kUsage, fmt::format("there is no option '{}' before a command", word));
  }
  std::string names;
  for (const CLI::App* command : program.get_subcommands(nullptr)) {
    if (command->get_name() == word) return;
    names += (names.empty() ? "" : ", ") + command->get_name();
  }
  throw CommandFailure(kUsage, fmt::format("there is no command '{}', expected one of {}", word, names));
}

int runProgram(int argc, char** argv) {
  CLI::App program("Processes surfaces given as points.", "stipple-cli");
  program.require_subcommand(1);
  Command chosen;
  addInfo(program, chosen);
  addConvert(program, chosen);
  addDiscretize(program, chosen);
  addOperators(program, chosen);
  addRun(program, chosen);
  addPlay(program, chosen);
  addRender(program, chosen);
  addTurntable(program, chosen);
  program.set_version_flag("--version", "stipple-cli " STIPPLE_VERSION);
  for (CLI::App* command : program.get_subcommands({})) {
    command->set_version_flag("--version", "stipple-cli " STIPPLE_VERSION);
  }
  try {
    if (argc > 1) checkFirstWord(program, argv[1]);
    program.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return program.exit(success);
  } catch (const CLI::ParseError& error) {
    return fail(kUsage, error.what());
  } catch (const CommandFailure& failure) {
    return fail(failure.code(), failure.what());
  }
  return perform(chosen);
}

}  // namespace
}  // namespace stipple

int main(int argc, char** argv) {
  return stipple::runProgram(argc, argv);
}
