#include <benchmark/benchmark.h>

#include "core/points/edit.h"

// Differences over four columns (position, normal, color, height), each written since, so that every bit is
// compared.

namespace stipple {
namespace {

PointSet manyPoints(Index size) {
  PointSet points(std::vector<Eigen::Vector3f>(size, Eigen::Vector3f(1, 2, 3)));
  points.set("normal", std::vector<Eigen::Vector3f>(size, Eigen::Vector3f(0, 0, 1)));
  points.set("color", std::vector<Rgba8>(size, Rgba8{1, 2, 3, 4}));
  points.set("height", std::vector<float>(size, 5));
  return points;
}

// Every `stride`-th row gets other values in all columns.
PointSet changedEvery(const PointSet& points, Index stride) {
  PointSet next = points;
  const auto positions = next.editPositions();
  const auto normals = next.edit<Eigen::Vector3f>("normal");
  const auto colors = next.edit<Rgba8>("color");
  const auto heights = next.edit<float>("height");
  for (Index row = 0; row < next.size(); row += stride) {
    positions[row].x() += 1;
    normals[row].x() += 1;
    colors[row].r += 1;
    heights[row] += 1;
  }
  return next;
}

void setPointsPerSecond(benchmark::State& state) {
  state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * state.range(0));
}

void differenceWhereOneRowIn(benchmark::State& state) {
  const PointSet before = manyPoints(static_cast<Index>(state.range(0)));
  const PointSet after = changedEvery(before, static_cast<Index>(state.range(1)));
  std::size_t bytes = 0;
  for (auto _ : state) bytes = difference(before, after).memoryBytes();
  state.counters["held_bytes"] = static_cast<double>(bytes);
  setPointsPerSecond(state);
}
BENCHMARK(differenceWhereOneRowIn)
    ->ArgNames({"points", "stride"})
    ->ArgsProduct({{100'000, 1'000'000, 10'000'000}, {1, 100, 1'000'000'000}})
    ->Unit(benchmark::kMillisecond);

void differenceWithOneRowInTenRemoved(benchmark::State& state) {
  const PointSet before = manyPoints(static_cast<Index>(state.range(0)));
  std::vector<Index> removed;
  for (Index row = 0; row < before.size(); row += 10) removed.push_back(row);
  PointSet after = before;
  after.removeRows(removed);
  for (auto _ : state) benchmark::DoNotOptimize(difference(before, after, removed));
  setPointsPerSecond(state);
}
BENCHMARK(differenceWithOneRowInTenRemoved)->ArgName("points")->Arg(1'000'000)->Unit(benchmark::kMillisecond);

void applyAndRevertWhereOneRowIn(benchmark::State& state) {
  PointSet points = manyPoints(static_cast<Index>(state.range(0)));
  Edit edit = difference(points, changedEvery(points, static_cast<Index>(state.range(1))));
  for (auto _ : state) {
    edit.apply(points);
    edit.revert(points);
  }
  setPointsPerSecond(state);
}
BENCHMARK(applyAndRevertWhereOneRowIn)
    ->ArgNames({"points", "stride"})
    ->ArgsProduct({{1'000'000}, {1, 100, 1'000'000'000}})
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace stipple
