#include "core/io/text_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <optional>

#include "core/io/number_table.h"
#include "core/io/numbers.h"
#include "core/io/text_columns.h"

namespace stipple {

namespace {

constexpr std::uint64_t kLinesPerReport = 1 << 16;

bool isComment(std::string_view line) {
  return line.starts_with('#') || line.starts_with("//");
}

std::string_view withoutBlanks(std::string_view line) {
  while (!line.empty() && isBlank(line.front())) line.remove_prefix(1);
  return line;
}

// The words of a header line, without comment marks and quotes.
std::vector<std::string> wordsOf(std::string_view line) {
  while (!line.empty() && (line.front() == '#' || line.front() == '/' || isBlank(line.front())))
    line.remove_prefix(1);
  std::vector<std::string> words;
  for (std::string_view word = takeWord(line, isSeparator); !word.empty();
       word = takeWord(line, isSeparator)) {
    std::string bare(word);
    std::erase(bare, '"');
    words.push_back(std::move(bare));
  }
  return words;
}

class TextReader {
 public:
  TextReader(const InputFile& file, Progress& progress) : file_(file), progress_(progress), lines_(file) {}

  ReadResult read() {
    std::string_view line;
    while (lines_.next(line)) {
      if (lines_.number() % kLinesPerReport == 0) {
        progress_.throwIfCancelled();
        progress_.report(lines_.fraction(), "reading");
      }
      takeLine(withoutBlanks(line));
    }
    if (table_.rows() == 0) throw InvalidInput("holds 0 points");
    std::string extension = file_.path().extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    ReadResult result = assembleTable(table_, nameColumns(table_, headerWords_, extension), {});
    if (promised_ > 0 && promised_ != table_.rows()) {
      result.warnings.push_back(fmt::format("promises {} points, {} found", promised_, table_.rows()));
    }
    return result;
  }

 private:
  void takeLine(std::string_view line) {
    if (line.empty()) return;
    if (isComment(line)) {
      if (table_.columns == 0) headerWords_ = wordsOf(line);
      return;
    }
    const std::size_t before = table_.values.size();
    std::string_view rest = line;
    if (!appendNumbers(rest, table_.values)) {
      table_.values.resize(before);
      if (table_.columns > 0 || hasWordLine_) {
        throw InvalidInput(fmt::format("line {}: '{}' is not a number", lines_.number(),
                                       takeWord(rest, isSeparator).substr(0, 40)));
      }
      hasWordLine_ = true;
      headerWords_ = wordsOf(line);
      return;
    }
    takeRow(line, before);
  }

  void takeRow(std::string_view line, std::size_t before) {
    const std::size_t found = table_.values.size() - before;
    std::uint64_t count = 0;
    if (found == 1 && toCount(takeWord(line, isSeparator), count)) {
      table_.values.resize(before);
      promised_ += count;
      return;
    }
    if (table_.columns == 0) {
      if (found < 3)
        throw InvalidInput(
            fmt::format("line {} has {} columns, expected at least 3", lines_.number(), found));
      table_.columns = found;
    } else if (found != table_.columns) {
      throw InvalidInput(
          fmt::format("line {} has {} columns, expected {}", lines_.number(), found, table_.columns));
    }
  }

  const InputFile& file_;
  Progress& progress_;
  LineReader lines_;
  NumberTable table_;
  std::vector<std::string> headerWords_;
  bool hasWordLine_ = false;
  std::uint64_t promised_ = 0;
};

// The lines of a sample that are complete.
std::vector<std::string_view> completeLines(const FileSample& file) {
  std::vector<std::string_view> lines;
  std::string_view rest = file.head;
  while (!rest.empty()) {
    const std::size_t end = rest.find('\n');
    if (end == std::string_view::npos && file.size > file.head.size()) break;
    lines.push_back(rest.substr(0, end));
    rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
  }
  return lines;
}

// How many numbers a line has; nothing where a word is no number.
std::optional<std::size_t> countNumbers(std::string_view line) {
  std::vector<double> numbers;
  return appendNumbers(line, numbers) ? std::optional(numbers.size()) : std::nullopt;
}

}  // namespace

bool isTextCloud(const FileSample& file) {
  if (file.head.find('\0') != std::string::npos) return false;
  int wordLines = 0, countLines = 0;
  for (std::string_view line : completeLines(file)) {
    line = withoutBlanks(line);
    if (line.empty() || isComment(line)) continue;
    const auto numbers = countNumbers(line);
    if (numbers && *numbers >= 3) return true;
    if (numbers ? *numbers != 1 || ++countLines > 1 : ++wordLines > 1) return false;
  }
  return false;
}

bool isPtx(const FileSample& file) {
  const auto lines = completeLines(file);
  constexpr std::size_t kNumbers[] = {1, 1, 3, 3, 3, 3, 4, 4, 4, 4};
  if (lines.size() < std::size(kNumbers)) return false;
  for (std::size_t l = 0; l < std::size(kNumbers); ++l) {
    if (countNumbers(lines[l]) != kNumbers[l]) return false;
  }
  return true;
}

ReadResult readText(const InputFile& file, Progress& progress) {
  return TextReader(file, progress).read();
}

}  // namespace stipple
