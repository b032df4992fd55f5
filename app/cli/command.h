#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/progress.h"

namespace CLI {
class App;
}

namespace stipple {

/// Exit codes of the program.
enum ExitCode { kDone = 0, kFailed = 1, kUsage = 2, kFile = 3, kInterrupted = 130 };

/// Ends the command with a code of its own; what() is the line on stderr.
class CommandFailure : public Error {
 public:
  CommandFailure(ExitCode code, const std::string& sentence) : Error(sentence), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// What a command that succeeded prints: `text` on stdout, then `warnings` on stderr.
struct Outcome {
  std::string text = {};
  std::vector<std::string> warnings = {};
};

/// `document` with the warnings inside where the user asked for JSON, otherwise `text` and the warnings
/// beside it.
Outcome makeOutcome(bool asJson, nlohmann::ordered_json document, std::string text,
                    std::vector<std::string> warnings);

/// Adds an option that takes one of `words`; `choose` gets the place of the word that was given. Any other
/// word is refused with the list of them.
void addChoice(CLI::App& command, const std::string& name, std::vector<std::string> words,
               std::function<void(std::size_t)> choose, const std::string& help);

using Command = std::function<Outcome(Progress&)>;

/// Each adds one command to the program; `chosen` becomes the work of the command that the user names.
void addInfo(CLI::App& program, Command& chosen);
void addConvert(CLI::App& program, Command& chosen);
void addDiscretize(CLI::App& program, Command& chosen);
void addOperators(CLI::App& program, Command& chosen);
void addRun(CLI::App& program, Command& chosen);
void addPlay(CLI::App& program, Command& chosen);
void addRender(CLI::App& program, Command& chosen);
void addTurntable(CLI::App& program, Command& chosen);

}  // namespace stipple
