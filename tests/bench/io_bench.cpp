// Speed of reading: a binary PLY of 10 M points against reading its bytes and copying them once in the same
// run (bar: 3 times), and ASCII PLY in bytes per second on one core (bar: 80 MB/s).
#include <benchmark/benchmark.h>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <memory>
#include <random>

#include "core/io/point_io.h"
#include "core/parallel.h"

namespace stipple {
namespace {

PointSet randomPoints(Index count) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-1, 1);
  std::vector<Eigen::Vector3f> positions(count), normals(count);
  std::vector<Rgba8> colors(count);
  for (Index row = 0; row < count; ++row) {
    positions[row] = {uniform(random), uniform(random), uniform(random)};
    normals[row] = positions[row].normalized();
    const auto bits = static_cast<std::uint32_t>(random());
    colors[row] = {static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(bits >> 8),
                   static_cast<std::uint8_t>(bits >> 16)};
  }
  PointSet points(std::move(positions));
  points.set("normal", std::move(normals));
  points.set("color", std::move(colors));
  return points;
}

// A file that goes with this object.
class SampleFile {
 public:
  SampleFile(Index count, Encoding encoding)
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("stipple_bench_{}_{}.ply", ::getpid(), count)) {
    Progress progress;
    writePoints(path_, randomPoints(count), {.encoding = encoding}, progress);
  }
  ~SampleFile() { std::filesystem::remove(path_); }
  SampleFile(const SampleFile&) = delete;
  SampleFile& operator=(const SampleFile&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::size_t size() const { return std::filesystem::file_size(path_); }

 private:
  std::filesystem::path path_;
};

double secondsOf(const auto& action) {
  const auto begin = std::chrono::steady_clock::now();
  action();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void readAndCopy(const SampleFile& file) {
  const std::size_t size = file.size();
  const auto bytes = std::make_unique_for_overwrite<char[]>(size),
             copy = std::make_unique_for_overwrite<char[]>(size);
  const int descriptor = ::open(file.path().c_str(), O_RDONLY);
  for (std::size_t done = 0; done < size;) {
    const ssize_t got = ::read(descriptor, bytes.get() + done, size - done);
    if (got <= 0) break;
    done += static_cast<std::size_t>(got);
  }
  ::close(descriptor);
  std::memcpy(copy.get(), bytes.get(), size);
  benchmark::DoNotOptimize(copy[size / 2]);
}

void readAsPoints(const SampleFile& file) {
  Progress progress;
  benchmark::DoNotOptimize(readPoints(file.path(), progress).points.size());
}

void binaryPly(benchmark::State& state) {
  const SampleFile file(10'000'000, Encoding::kBinary);
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  double bytes = 1e9, points = 1e9;
  for (auto _ : state) {
    bytes = std::min(bytes, secondsOf([&] { readAndCopy(file); }));
    points = std::min(points, secondsOf([&] { readAsPoints(file); }));
  }
  state.counters["read_and_copy_s"] = bytes;
  state.counters["points_s"] = points;
  state.counters["ratio"] = points / bytes;
}
BENCHMARK(binaryPly)->ArgName("threads")->Arg(1)->Arg(0)->Iterations(5)->Unit(benchmark::kMillisecond);

void asciiPly(benchmark::State& state) {
  const SampleFile file(1'000'000, Encoding::kAscii);
  const ThreadLimit oneCore(1);
  double seconds = 1e9;
  for (auto _ : state) seconds = std::min(seconds, secondsOf([&] { readAsPoints(file); }));
  state.counters["MB_per_s"] = static_cast<double>(file.size()) / 1e6 / seconds;
}
BENCHMARK(asciiPly)->Iterations(5)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stipple
