#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

namespace stipple {

/// Bytes put aside on the disk. The file has no name, so that the disk has its room back when the program
/// ends, however it ends. Threads may share it.
class SpillFile {
 public:
  struct Extent {
    std::uint64_t offset = 0, size = 0;
  };

  /// The file is made in `folder`, and the folder where it is missing, at the first write.
  explicit SpillFile(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~SpillFile();
  SpillFile(const SpillFile&) = delete;
  SpillFile& operator=(const SpillFile&) = delete;

  /// Throws IoError, keeping what was there, where the disk does not take the bytes.
  Extent write(std::span<const std::byte> bytes);
  std::vector<std::byte> read(const Extent& extent) const;
  /// The bytes are not needed any more.
  void drop(const Extent& extent);

  /// Of all that was written and not dropped.
  std::uint64_t bytes() const;

 private:
  [[noreturn]] void fail(int error) const;
  void open();

  std::filesystem::path folder_;
  mutable std::mutex mutex_;
  int descriptor_ = -1;
  std::uint64_t end_ = 0;    // where the next extent begins
  std::uint64_t bytes_ = 0;  // of the extents in use
};

}  // namespace stipple
