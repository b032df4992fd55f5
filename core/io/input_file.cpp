#include "core/io/input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "core/error.h"

namespace stipple {

namespace {

constexpr std::size_t kWindowBytes = std::size_t{1}
                                     << 20;  // large enough for the disk, small enough for the cache

[[noreturn]] void fail(const std::filesystem::path& path, std::string_view what) {
  throw IoError(fmt::format("{}: {}", path.string(), what));
}

}  // namespace

InputFile::InputFile(const std::filesystem::path& path) : path_(path) {
  struct stat status {};
  if (::stat(path.c_str(), &status) != 0) {
    fail(path, errno == ENOENT ? std::string("there is no such file")
                               : fmt::format("cannot be read ({})", std::strerror(errno)));
  }
  if (S_ISDIR(status.st_mode)) fail(path, "is a directory, expected a file of points");
  if (!S_ISREG(status.st_mode)) fail(path, "is not a regular file");
  descriptor_ = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) fail(path, fmt::format("cannot be read ({})", std::strerror(errno)));
  size_ = static_cast<std::uint64_t>(status.st_size);
}

InputFile::InputFile(std::filesystem::path name, std::span<const std::byte> bytes)
    : path_(std::move(name)), size_(bytes.size()), memory_(bytes) {}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

std::size_t InputFile::read(std::uint64_t offset, std::span<std::byte> into) const {
  if (offset >= size_) return 0;
  const auto wanted = static_cast<std::size_t>(std::min<std::uint64_t>(into.size(), size_ - offset));
  if (descriptor_ < 0) {
    if (wanted > 0) std::memcpy(into.data(), memory_.data() + offset, wanted);
    return wanted;
  }
  std::size_t done = 0;
  while (done < wanted) {
    const ssize_t got =
        ::pread(descriptor_, into.data() + done, wanted - done, static_cast<off_t>(offset + done));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) fail(path_, fmt::format("cannot be read ({})", std::strerror(errno)));
    if (got == 0) fail(path_, "became shorter while it was read");
    done += static_cast<std::size_t>(got);
  }
  return done;
}

std::string InputFile::head(std::size_t count) const {
  std::string text(static_cast<std::size_t>(std::min<std::uint64_t>(count, size_)), '\0');
  text.resize(read(0, std::as_writable_bytes(std::span(text.data(), text.size()))));
  return text;
}

bool ByteCursor::refill(std::size_t count) {
  if (count > remaining()) return false;
  const std::size_t kept = end_ - begin_;
  if (count > capacity_) {
    capacity_ = std::max(count, static_cast<std::size_t>(std::min<std::uint64_t>(kWindowBytes, remaining())));
    auto larger = std::make_unique_for_overwrite<std::byte[]>(capacity_);
    if (kept > 0) std::memcpy(larger.get(), window_.get() + begin_, kept);
    window_ = std::move(larger);
  } else if (kept > 0) {
    std::memmove(window_.get(), window_.get() + begin_, kept);
  }
  begin_ = 0;
  end_ = kept + file_.read(next_, {window_.get() + kept, capacity_ - kept});
  next_ += end_ - kept;
  return true;
}

bool ByteCursor::skip(std::uint64_t count) {
  if (count > remaining()) return false;
  if (count <= end_ - begin_) {
    begin_ += static_cast<std::size_t>(count);
  } else {
    next_ = offset() + count;
    begin_ = end_ = 0;
  }
  return true;
}

TextLayout layoutOf(std::string_view head) {
  const bool hasOnlyCr = head.find('\n') == head.npos && head.find('\r') != head.npos;
  return {.begin = head.starts_with("\xEF\xBB\xBF") ? std::size_t{3} : 0, .newline = hasOnlyCr ? '\r' : '\n'};
}

LineReader::LineReader(const InputFile& file, std::uint64_t offset, std::uint64_t linesBefore)
    : file_(file), next_(offset), number_(linesBefore) {
  const TextLayout layout = layoutOf(file.head(InputFile::kHeadBytes));
  newline_ = layout.newline;
  if (offset == 0) next_ = layout.begin;
}

bool LineReader::fill() {
  if (next_ >= file_.size()) return false;
  if (begin_ > 0) {
    std::memmove(window_.data(), window_.data() + begin_, end_ - begin_);
    end_ -= begin_;
    begin_ = 0;
  }
  if (end_ == window_.size()) {
    const std::size_t larger = std::max(kWindowBytes, 2 * window_.size());
    window_.resize(static_cast<std::size_t>(std::min<std::uint64_t>(larger, end_ + file_.size() - next_)));
  }
  const std::size_t got = file_.read(next_, std::as_writable_bytes(std::span(window_).subspan(end_)));
  end_ += got;
  next_ += got;
  return got > 0;
}

bool LineReader::next(std::string_view& line) {
  std::size_t searched = begin_;
  const char* newline = nullptr;
  for (;;) {
    if (end_ > searched) {
      newline = static_cast<const char*>(std::memchr(window_.data() + searched, newline_, end_ - searched));
    }
    if (newline) break;
    const std::size_t tail = end_ - begin_;
    if (!fill()) break;
    searched = begin_ + tail;
  }
  if (!newline && begin_ == end_) return false;
  const std::size_t stop = newline ? static_cast<std::size_t>(newline - window_.data()) : end_;
  line = {window_.data() + begin_, stop - begin_};
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  begin_ = newline ? stop + 1 : end_;
  ++number_;
  return true;
}

}  // namespace stipple
