#pragma once

#include <filesystem>
#include <memory>
#include <set>
#include <string>

namespace stipple {

/// Notes on disk which plugin is at work, so that one that takes the program down starts disabled the next
/// time. Programs at the same time do not disturb each other.
class PluginSentinel {
 public:
  /// Reads, in `folder`, which plugins are off, and turns off those that were at work when their program
  /// ended. Where the folder cannot be written nothing is noted.
  explicit PluginSentinel(std::filesystem::path folder);

  bool isOff(const std::filesystem::path& plugin) const { return off_.contains(plugin); }
  const std::set<std::filesystem::path>& off() const { return off_; }
  void turnOnAll();

  /// While it lives the plugin is at work.
  class Watch {
   public:
    explicit Watch(std::filesystem::path file, int descriptor)
        : file_(std::move(file)), descriptor_(descriptor) {}
    ~Watch();
    Watch(const Watch&) = delete;
    Watch& operator=(const Watch&) = delete;

   private:
    std::filesystem::path file_;
    int descriptor_;
  };
  std::unique_ptr<Watch> watch(const std::filesystem::path& plugin);

 private:
  void collectFallen();
  void write() const;

  std::filesystem::path folder_;
  std::set<std::filesystem::path> off_;
  int watches_ = 0;
};

}  // namespace stipple
