#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// What a program printed and how it ended.
struct ProgramRun {
  std::string out, err;
  int exitCode = -1;  ///< -1 where a signal ended it
  std::size_t peakBytes = 0;
};

struct ProgramOptions {
  std::vector<std::string> environment = {};  ///< NAME=VALUE, set beside those of this process
  int interruptAfterMs = 0;                   ///< > 0: sends SIGINT that long after the start
  std::string outputPath = {};                ///< stdout goes to this file and `out` stays empty
};

/// Runs a program to its end with closed stdin.
ProgramRun runProgram(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      const ProgramOptions& options = {});

/// How often a line ends in the text.
int countLines(const std::string& text);
