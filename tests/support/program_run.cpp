#include "tests/support/program_run.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <thread>

namespace {

namespace fs = std::filesystem;

std::string readAll(const fs::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

void redirect(int descriptor, const fs::path& path, int flags) {
  const int file = open(path.c_str(), flags, 0600);
  if (file < 0 || dup2(file, descriptor) < 0) _exit(125);
  close(file);
}

[[noreturn]] void becomeProgram(const fs::path& program, const std::vector<std::string>& arguments,
                                const ProgramOptions& options, const fs::path& out, const fs::path& err) {
  redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  redirect(STDOUT_FILENO, out, O_WRONLY | O_CREAT | O_TRUNC);
  redirect(STDERR_FILENO, err, O_WRONLY | O_CREAT | O_TRUNC);
  for (const std::string& setting : options.environment) putenv(const_cast<char*>(setting.c_str()));
  std::vector<char*> argv = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
  argv.push_back(nullptr);
  execv(program.c_str(), argv.data());
  _exit(126);
}

}  // namespace

ProgramRun runProgram(const fs::path& program, const std::vector<std::string>& arguments,
                      const ProgramOptions& options) {
  static int runs = 0;
  const std::string name = "stipple_run_" + std::to_string(getpid()) + "_" + std::to_string(runs++);
  const fs::path ownOut = fs::temp_directory_path() / (name + ".out");
  const fs::path err = fs::temp_directory_path() / (name + ".err");
  const fs::path out = options.outputPath.empty() ? ownOut : fs::path(options.outputPath);
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("cannot start a process");
  if (child == 0) becomeProgram(program, arguments, options, out, err);
  if (options.interruptAfterMs > 0) {
    std::this_thread::sleep_for(std::chrono::milliseconds(options.interruptAfterMs));
    kill(child, SIGINT);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  ProgramRun run{.out = options.outputPath.empty() ? readAll(out) : "",
                 .err = readAll(err),
                 .exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : -1,
                 .peakBytes = static_cast<std::size_t>(usage.ru_maxrss) * 1024};
  fs::remove(ownOut);
  fs::remove(err);
  return run;
}

int countLines(const std::string& text) {
  return static_cast<int>(std::ranges::count(text, '\n'));
}
