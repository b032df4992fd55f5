#include <fmt/format.h>

#include <Eigen/Core>

#include "core/io/number_table.h"
#include "core/io/numbers.h"
#include "core/io/text_columns.h"
#include "core/io/text_reader.h"

namespace stipple {

namespace {

constexpr std::uint64_t kLinesPerReport = 1 << 16;

class PtxReader {
 public:
  PtxReader(const InputFile& file, Progress& progress) : progress_(progress), lines_(file) {}

  ReadResult read() {
    std::vector<double> numbers;
    while (nextRow(numbers)) {
      if (numbers.size() == 1) {
        readHeader(numbers[0]);
      } else {
        addPoint(numbers);
      }
    }
    if (table_.rows() == 0) throw InvalidInput("holds 0 points");
    ReadResult result = assembleTable(table_, nameColumns(table_, {}, ".ptx"), {});
    if (promised_ != static_cast<double>(table_.rows())) {
      result.warnings.push_back(fmt::format("promises {} points, {} found", promised_, table_.rows()));
    }
    if (empty_ > 0) {
      result.warnings.push_back(
          fmt::format("{} points lie in the scanner, which is how PTX marks rays that hit nothing", empty_));
    }
    return result;
  }

 private:
  bool nextRow(std::vector<double>& numbers) {
    std::string_view line;
    do {
      if (!lines_.next(line)) return false;
      if (lines_.number() % kLinesPerReport == 0) {
        progress_.throwIfCancelled();
        progress_.report(lines_.fraction(), "reading");
      }
      numbers.clear();
      if (!appendNumbers(line, numbers)) {
        throw InvalidInput(fmt::format("line {}: '{}' is not a number", lines_.number(),
                                       takeWord(line, isSeparator).substr(0, 40)));
      }
    } while (numbers.empty());
    return true;
  }

  void readHeaderRow(std::vector<double>& numbers, std::size_t expected) {
    numbers.clear();
    if (nextRow(numbers) && numbers.size() == expected) return;
    throw InvalidInput(fmt::format("line {} of a scan's header has {} columns, expected {}", lines_.number(),
                                   numbers.size(), expected));
  }

  // The number of rows, the scanner's place and axes (which the matrix repeats), the matrix for row vectors.
  void readHeader(double scanColumns) {
    std::vector<double> numbers;
    readHeaderRow(numbers, 1);
    promised_ += scanColumns * numbers[0];
    for (int line = 0; line < 4; ++line) readHeaderRow(numbers, 3);
    for (int row = 0; row < 4; ++row) {
      readHeaderRow(numbers, 4);
      for (int column = 0; column < 4; ++column)
        worldFromScan_(column, row) = numbers[static_cast<std::size_t>(column)];
    }
  }

  void addPoint(std::vector<double>& numbers) {
    if (table_.columns == 0) {
      if (numbers.size() < 3) {
        throw InvalidInput(
            fmt::format("line {} has {} columns, expected at least 3", lines_.number(), numbers.size()));
      }
      table_.columns = numbers.size();
    } else if (numbers.size() != table_.columns) {
      throw InvalidInput(fmt::format("line {} has {} columns, expected {}", lines_.number(), numbers.size(),
                                     table_.columns));
    }
    const Eigen::Vector3d point(numbers[0], numbers[1], numbers[2]);
    if (point.isZero(0)) ++empty_;
    if (!worldFromScan_.isIdentity(0)) {
      Eigen::Map<Eigen::Vector3d>(numbers.data()) =
          worldFromScan_.topLeftCorner<3, 3>() * point + worldFromScan_.topRightCorner<3, 1>();
    }
    table_.values.insert(table_.values.end(), numbers.begin(), numbers.end());
  }

  Progress& progress_;
  LineReader lines_;
  NumberTable table_;
  Eigen::Matrix4d worldFromScan_ = Eigen::Matrix4d::Identity();
  double promised_ = 0;
  std::size_t empty_ = 0;
};

}  // namespace

ReadResult readPtx(const InputFile& file, Progress& progress) {
  return PtxReader(file, progress).read();
}

}  // namespace stipple
