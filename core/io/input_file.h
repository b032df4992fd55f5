#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stipple {

/// A regular file, or bytes in memory under a name. Reads are independent of each other and may run on any
/// thread.
class InputFile {
 public:
  /// Enough of the first bytes to see past the comments that text formats begin with.
  static constexpr std::size_t kHeadBytes = 1 << 16;

  /// Throws IoError: missing, a directory, not a regular file, unreadable.
  explicit InputFile(const std::filesystem::path& path);
  /// Bytes that must outlive this object; `name` is for messages and the choice of the format.
  InputFile(std::filesystem::path name, std::span<const std::byte> bytes);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::uint64_t size() const { return size_; }
  /// Fills `into` from `offset` on; returns how many bytes there were, fewer only at the end of the file.
  std::size_t read(std::uint64_t offset, std::span<std::byte> into) const;
  /// The first bytes of the file, at most `count`.
  std::string head(std::size_t count) const;

 private:
  std::filesystem::path path_;
  std::uint64_t size_ = 0;
  int descriptor_ = -1;
  std::span<const std::byte> memory_;
};

/// Walks through a file once, through a window that grows only for single items larger than it.
class ByteCursor {
 public:
  ByteCursor(const InputFile& file, std::uint64_t offset) : file_(file), next_(offset) {}

  /// The next `count` bytes, valid until the next call; null (and nothing taken) where the file has fewer.
  const std::byte* take(std::size_t count) {
    if (end_ - begin_ < count && !refill(count)) return nullptr;
    const std::byte* bytes = window_.get() + begin_;
    begin_ += count;
    return bytes;
  }
  /// False (and nothing skipped) where the file has fewer bytes.
  bool skip(std::uint64_t count);
  std::uint64_t offset() const { return next_ - (end_ - begin_); }
  std::uint64_t remaining() const { return offset() < file_.size() ? file_.size() - offset() : 0; }

 private:
  bool refill(std::size_t count);

  const InputFile& file_;
  std::uint64_t next_;  // file offset of the byte after the window
  std::unique_ptr<std::byte[]> window_;
  std::size_t capacity_ = 0, begin_ = 0, end_ = 0;
};

/// Where the text of a file begins, and what ends its lines.
struct TextLayout {
  std::size_t begin = 0;  ///< behind a byte order mark of UTF-8
  char newline = '\n';    ///< with or without a CR before it; CR where the first bytes have no LF at all
};
TextLayout layoutOf(std::string_view head);

/// Walks through the lines of a text file; ends of lines may be LF, CRLF or a mixture, or CR throughout.
class LineReader {
 public:
  explicit LineReader(const InputFile& file, std::uint64_t offset = 0, std::uint64_t linesBefore = 0);

  /// The next line without its end, valid until the next call; false at the end of the file.
  bool next(std::string_view& line);
  /// Number of the line returned last, from 1.
  std::uint64_t number() const { return number_; }
  /// File offset of the line that comes next.
  std::uint64_t offset() const { return next_ - (end_ - begin_); }
  double fraction() const {
    return file_.size() ? static_cast<double>(offset()) / static_cast<double>(file_.size()) : 1;
  }

 private:
  bool fill();

  const InputFile& file_;
  std::uint64_t next_;
  std::uint64_t number_;
  char newline_;
  std::vector<char> window_;
  std::size_t begin_ = 0, end_ = 0;
};

}  // namespace stipple
