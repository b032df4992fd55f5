#include "app/plugins/sentinel.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <fstream>
#include <system_error>

namespace stipple {

namespace {

namespace fs = std::filesystem;

constexpr const char* kOffFile = "plugins-off";
constexpr const char* kAtWork = ".at-work";

std::string firstLine(const fs::path& file) {
  std::string line;
  std::ifstream stream(file);
  std::getline(stream, line);
  return line;
}

// No living program holds it.
bool isLeftBehind(const fs::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool isFree = ::flock(descriptor, LOCK_EX | LOCK_NB) == 0;
  ::close(descriptor);
  return isFree;
}

}  // namespace

PluginSentinel::PluginSentinel(fs::path folder) : folder_(std::move(folder)) {
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  std::ifstream stream(folder_ / kOffFile);
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) off_.insert(line);
  }
  collectFallen();
}

void PluginSentinel::collectFallen() {
  std::error_code unreadable;
  bool isAny = false;
  for (const auto& entry : fs::directory_iterator(folder_, unreadable)) {
    if (entry.path().extension() != kAtWork || !isLeftBehind(entry.path())) continue;
    if (const std::string plugin = firstLine(entry.path()); !plugin.empty()) {
      off_.insert(plugin);
      isAny = true;
    }
    std::error_code vanished;
    fs::remove(entry.path(), vanished);
  }
  if (isAny) write();
}

void PluginSentinel::write() const {
  std::ofstream stream(folder_ / kOffFile, std::ios::trunc);
  for (const fs::path& plugin : off_) stream << plugin.string() << '\n';
}

void PluginSentinel::turnOnAll() {
  off_.clear();
  write();
}

std::unique_ptr<PluginSentinel::Watch> PluginSentinel::watch(const fs::path& plugin) {
  const fs::path file = folder_ / fmt::format("{}-{}{}", ::getpid(), watches_++, kAtWork);
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (descriptor < 0) return std::make_unique<Watch>(fs::path(), -1);
  ::flock(descriptor, LOCK_EX | LOCK_NB);
  const std::string line = plugin.string() + '\n';
  [[maybe_unused]] const auto written = ::write(descriptor, line.data(), line.size());
  return std::make_unique<Watch>(file, descriptor);
}

PluginSentinel::Watch::~Watch() {
  if (descriptor_ < 0) return;
  std::error_code ignored;
  fs::remove(file_, ignored);
  ::close(descriptor_);
}

}  // namespace stipple
