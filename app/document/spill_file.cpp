#include "app/document/spill_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "core/error.h"

namespace stipple {

SpillFile::~SpillFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void SpillFile::fail(int error) const {
  throw IoError(fmt::format("{}: {}", folder_.string(), std::generic_category().message(error)));
}

void SpillFile::open() {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  std::string name = (folder_ / "undo-XXXXXX").string();
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) fail(errno);
  ::unlink(name.c_str());
}

SpillFile::Extent SpillFile::write(std::span<const std::byte> bytes) {
  const std::lock_guard lock(mutex_);
  if (descriptor_ < 0) open();
  const Extent extent{.offset = end_, .size = bytes.size()};
  while (!bytes.empty()) {
    const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(end_));
    if (written <= 0) {
      if (written < 0 && errno == EINTR) continue;
      const int error = written < 0 ? errno : ENOSPC;
      end_ = extent.offset;
      if (::ftruncate(descriptor_, static_cast<off_t>(end_)) != 0) fail(errno);
      fail(error);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
    end_ += static_cast<std::uint64_t>(written);
  }
  bytes_ += extent.size;
  return extent;
}

std::vector<std::byte> SpillFile::read(const Extent& extent) const {
  const std::lock_guard lock(mutex_);
  std::vector<std::byte> bytes(extent.size);
  for (std::size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::pread(descriptor_, bytes.data() + done, bytes.size() - done,
                                  static_cast<off_t>(extent.offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) fail(count < 0 ? errno : EIO);
    done += static_cast<std::size_t>(count);
  }
  return bytes;
}

std::uint64_t SpillFile::bytes() const {
  const std::lock_guard lock(mutex_);
  return bytes_;
}

// Gives the blocks back; where the file system cannot do that they come back at the end.
void SpillFile::drop(const Extent& extent) {
  const std::lock_guard lock(mutex_);
  bytes_ -= extent.size;
  if (extent.offset + extent.size == end_) end_ = extent.offset;
  if (bytes_ == 0) end_ = 0;
  const bool atEnd = end_ <= extent.offset;
  const int gone = atEnd ? ::ftruncate(descriptor_, static_cast<off_t>(end_))
                         : ::fallocate(descriptor_, FALLOC_FL_PUNCH_HOLE | FALLOC_FL_KEEP_SIZE,
                                       static_cast<off_t>(extent.offset), static_cast<off_t>(extent.size));
  static_cast<void>(gone);
}

}  // namespace stipple
