#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace stipple {

/// A file that appears only when it is complete: written beside the target under a name of its own, synced
/// and renamed by commit(). Without commit() the target stays as it was. A target that is a link is followed,
/// its mode is kept; a device or pipe is written directly. Every failure is an IoError that starts with the
/// path asked for.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::span<const std::byte> bytes);
  void write(std::string_view text) { write(std::as_bytes(std::span(text.data(), text.size()))); }
  /// Throws where the bytes did not reach the disk; the target is then unchanged.
  void commit();

 private:
  [[noreturn]] void fail(int error) const;
  void openBeside();
  void flush(std::span<const std::byte> bytes);

  std::filesystem::path path_, target_, temporary_;
  int descriptor_ = -1;
  std::vector<std::byte> buffer_;
};

}  // namespace stipple
