#include "plugins/inpainting/exemplar_fill.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "tests/plugins/inpainting/inpaint_points.h"
#include "tests/support/cancel_after.h"
#include "tests/support/identical.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

using testing::HasSubstr;

const std::string kExemplar = "exemplar";

PointSet fillTexture(const PointSet& points, const std::vector<Index>& masked, const std::string& method,
                     Report* report = nullptr) {
  return inpaint(points, masked, {{"attribute", std::string("texture")}, {"method", method}}, report);
}

// 0 and 1, in waves of the square of 100 x 100 points.
double wave(double x) {
  return std::sin(2 * std::numbers::pi * x);
}
double stripes(const Eigen::Vector3f& p) {
  return wave((p.x() + 0.3 * p.y()) / 0.08) > 0 ? 1 : 0;
}
double checkers(const Eigen::Vector3f& p) {
  return wave(p.x() / 0.16) * wave(p.y() / 0.16) > 0 ? 1 : 0;
}

// A texture on a set with a hole where it was lost.
struct Damaged {
  PointSet points;
  std::vector<Index> masked;
  std::vector<double> truth;

  Damaged(std::vector<Eigen::Vector3f> positions, const Eigen::Vector3f& center, float radius,
          const Texture& texture)
      : points(std::move(positions)), masked(rowsAround(points, center, radius)) {
    for (const Eigen::Vector3f& p : points.positions()) truth.push_back(texture(p));
    std::vector<double> given = truth;
    for (const Index row : masked) given[row] = -5;
    points.set("texture", given);
  }
  double errorOf(const PointSet& filled) const {
    double sum = 0;
    for (const Index row : masked) sum += std::pow(filled.values<double>("texture")[row] - truth[row], 2);
    return std::sqrt(sum / static_cast<double>(masked.size()));
  }
  double contrastOf(std::span<const double> values) const {
    double sum = 0, squares = 0;
    for (const Index row : masked) {
      sum += values[row];
      squares += values[row] * values[row];
    }
    const auto count = static_cast<double>(masked.size());
    return std::sqrt(squares / count - sum * sum / (count * count));
  }
};

// Root mean square over samples of the square. One point in ten has the wrong one of two values where the
// error is .32; a gray fill has .5.
double meanHoleError(const Texture& texture, const std::string& method) {
  constexpr std::uint64_t kSamples = 4;
  double sum = 0;
  for (std::uint64_t seed = 1; seed <= kSamples; ++seed) sum += std::pow(holeError(texture, method, seed), 2);
  return std::sqrt(sum / kSamples);
}

TEST(Exemplar, StripesAndCheckersRunOnInPhase) {
  EXPECT_LT(meanHoleError(stripes, kExemplar), 0.32);
  EXPECT_LT(meanHoleError(checkers, kExemplar), 0.32);
  EXPECT_GT(meanHoleError(stripes, "harmonic"), 0.45);
  for (const char* method : {"harmonic", "tensor", "biharmonic"})
    EXPECT_GT(meanHoleError(checkers, method), 0.45) << method;
}

TEST(Exemplar, ATextureKeepsItsContrast) {
  const Damaged damaged(shapes::randomSquare(10000, 3), {0.5f, 0.5f, 0}, 0.15f, checkers);
  const double truth = damaged.contrastOf(damaged.truth);
  const auto contrast = [&](const char* method) {
    return damaged.contrastOf(fillTexture(damaged.points, damaged.masked, method).values<double>("texture"));
  };
  EXPECT_NEAR(contrast("exemplar"), truth, 0.1 * truth);
  EXPECT_LT(contrast("harmonic"), 0.5 * truth);
}

// Rings of equal width about an axis meet themselves again only where patches turn with the surface. Of
// points thrown at random more lie at the edges of rings: one in six may be wrong.
TEST(Exemplar, RingsOfASphereCloseAcrossAHole) {
  const auto rings = [](const Eigen::Vector3f& p) { return wave(std::asin(p.z()) / 0.2) > 0 ? 1.0 : 0.0; };
  for (const Eigen::Vector3f& center : {Eigen::Vector3f(1, 0, 0), Eigen::Vector3f(0.6f, 0.64f, 0.48f)}) {
    const Damaged damaged(shapes::randomSphere(20000, 4), center, 0.25f, rings);
    ASSERT_GT(damaged.masked.size(), 250u);
    EXPECT_LT(damaged.errorOf(fillTexture(damaged.points, damaged.masked, "exemplar")), 0.41);
    EXPECT_GT(damaged.errorOf(fillTexture(damaged.points, damaged.masked, "harmonic")), 0.45);
  }
}

TEST(Exemplar, OneColorStaysThatColor) {
  PointSet points(shapes::randomSquare(4000, 9));
  const Rgba8 green{17, 203, 98, 255};
  std::vector<Rgba8> colors(points.size(), green);
  const std::vector<Index> masked = rowsAround(points, {0.4f, 0.6f, 0}, 0.2f);
  for (const Index row : masked) colors[row] = {255, 0, 255, 255};
  points.set("color", colors);
  const PointSet filled = inpaint(points, masked, {{"method", kExemplar}});
  for (const Rgba8& color : filled.values<Rgba8>("color")) EXPECT_EQ(color, green);
}

TEST(Exemplar, EveryValueIsOneOfTheKnown) {
  PointSet points(shapes::randomSquare(6000, 2));
  const std::vector<Index> masked = rowsAround(points, {0.5f, 0.5f, 0}, 0.2f);
  std::mt19937_64 random(6);
  std::vector<std::int32_t> labels;
  std::vector<Rgba8> colors;
  for (Index row = 0; row < points.size(); ++row) {
    labels.push_back(std::array{3, 7, 1000}[random() % 3]);
    const auto byte = [&] { return static_cast<std::uint8_t>(random() % 256); };
    colors.push_back({byte(), byte(), byte(), 255});
  }
  const auto keyOf = [](const Rgba8& c) { return c.r << 16 | c.g << 8 | c.b; };
  std::set<int> known;
  for (Index row = 0; row < points.size(); ++row) {
    if (!std::ranges::binary_search(masked, row)) known.insert(keyOf(colors[row]));
  }
  for (const Index row : masked) labels[row] = 0;
  points.set("texture", labels);
  points.set("color", colors);
  const PointSet filledLabels = fillTexture(points, masked, kExemplar);
  const PointSet filledColors = inpaint(points, masked, {{"method", kExemplar}});
  for (const Index row : masked) {
    EXPECT_THAT(filledLabels.values<std::int32_t>("texture")[row], testing::AnyOf(3, 7, 1000));
    EXPECT_TRUE(known.contains(keyOf(filledColors.values<Rgba8>("color")[row])));
  }
}

// The normals of a sphere are one vector in its tangent frames.
TEST(Exemplar, VectorsTurnWithTheSurface) {
  PointSet points(shapes::randomSphere(8000, 2));
  std::vector<Eigen::Vector3f> normals(points.positions().begin(), points.positions().end());
  const std::vector<Index> masked = rowsAround(points, {0, 0, 1}, 0.4f);
  for (const Index row : masked) normals[row].setZero();
  points.set("normal", normals);
  const PointSet filled =
      inpaint(points, masked, {{"attribute", std::string("normal")}, {"method", kExemplar}});
  for (const Index row : masked) {
    EXPECT_NEAR(filled.values<Eigen::Vector3f>("normal")[row].norm(), 1, 1e-5);
    EXPECT_GT(filled.values<Eigen::Vector3f>("normal")[row].dot(points.positions()[row]), 0.98);
  }
}

TEST(Exemplar, WorksOfAnySizeAndNumberOfHoles) {
  Damaged damaged(shapes::randomSquare(20000, 5), {0.3f, 0.3f, 0}, 0.1f, checkers);
  std::vector<double> given(damaged.points.values<double>("texture").begin(),
                            damaged.points.values<double>("texture").end());
  for (Index row = 0; row < damaged.points.size(); row += 97) damaged.masked.push_back(row);
  for (const Index row : rowsAround(damaged.points, {0.8f, 0.9f, 0}, 0.15f)) damaged.masked.push_back(row);
  std::ranges::sort(damaged.masked);
  damaged.masked.erase(std::ranges::unique(damaged.masked).begin(), damaged.masked.end());
  for (const Index row : damaged.masked) given[row] = -5;
  damaged.points.set("texture", given);
  Report report;
  const PointSet filled = fillTexture(damaged.points, damaged.masked, kExemplar, &report);
  EXPECT_TRUE(report.warnings.empty());
  EXPECT_LT(damaged.errorOf(filled), 0.4);
}

TEST(Exemplar, WithoutAWholePatchNearTheTensorFillStays) {
  // All but two columns and a corner are masked: no known patch is whole.
  PointSet points(shapes::grid(60));
  std::vector<double> values;
  std::vector<Index> masked;
  for (Index row = 0; row < points.size(); ++row) {
    values.push_back(points.positions()[row].y());
    if (row % 60 > 1 && row > 200) masked.push_back(row);
  }
  points.set("texture", values);
  Report report;
  const PointSet filled = fillTexture(points, masked, kExemplar, &report);
  ASSERT_EQ(report.warnings.size(), 1u);
  EXPECT_THAT(report.warnings.front(), HasSubstr(std::to_string(masked.size()) + " points"));
  EXPECT_THAT(report.warnings.front(), HasSubstr("tensor"));
  EXPECT_TRUE(identical(filled, fillTexture(points, masked, "tensor")));
}

TEST(Exemplar, NearlyAllMaskedStaysFinite) {
  Damaged damaged(shapes::randomSquare(6000, 8), {0.5f, 0.5f, 0}, 0.6f, stripes);
  const PointSet filled = fillTexture(damaged.points, damaged.masked, kExemplar);
  for (const double value : filled.values<double>("texture")) {
    EXPECT_GE(value, 0);
    EXPECT_LE(value, 1);
  }
}

TEST(Exemplar, ValuesThatAreNoneAreNoExample) {
  Damaged damaged(shapes::randomSquare(10000, 3), {0.5f, 0.5f, 0}, 0.1f, stripes);
  std::vector<double> given(damaged.points.values<double>("texture").begin(),
                            damaged.points.values<double>("texture").end());
  for (Index row = 0; row < damaged.points.size(); row += 7) {
    if (!std::ranges::binary_search(damaged.masked, row)) given[row] = std::nan("");
  }
  damaged.points.set("texture", given);
  const PointSet filled = fillTexture(damaged.points, damaged.masked, kExemplar);
  EXPECT_LT(damaged.errorOf(filled), 0.36);
  for (Index row = 0; row < given.size(); ++row) {
    if (!std::ranges::binary_search(damaged.masked, row)) {
      EXPECT_EQ(std::isnan(filled.values<double>("texture")[row]), std::isnan(given[row]));
    }
  }
}

// Ranges whose squares no float holds.
TEST(Exemplar, TheUnitOfTheValuesDoesNotMatter) {
  const Damaged damaged(shapes::randomSquare(5000, 3), {0.5f, 0.5f, 0}, 0.1f, stripes);
  const PointSet filled = fillTexture(damaged.points, damaged.masked, kExemplar);
  for (const double unit : {std::ldexp(1.0, 200), std::ldexp(1.0, -200)}) {
    PointSet scaled = damaged.points;
    for (double& value : scaled.edit<double>("texture")) value *= unit;
    const PointSet found = fillTexture(scaled, damaged.masked, kExemplar);
    for (const Index row : damaged.masked)
      EXPECT_EQ(found.values<double>("texture")[row], unit * filled.values<double>("texture")[row]);
  }
}

TEST(Exemplar, SameBitsForAnyNumberOfThreads) {
  const Damaged damaged(shapes::randomSphere(12000, 3), {0, 1, 0}, 0.3f, checkers);
  const auto filled = [&](int threads) {
    const ThreadLimit limit(threads);
    return fillTexture(damaged.points, damaged.masked, kExemplar);
  };
  EXPECT_TRUE(identical(filled(1), filled(2)));
}

TEST(Exemplar, EveryStepShowsAFillAndMayBeCancelled) {
  const Damaged damaged(shapes::randomSquare(8000, 3), {0.5f, 0.5f, 0}, 0.15f, checkers);
  const auto run = makeInpainting()->start(
      damaged.points, regionOfRows(damaged.points, damaged.masked),
      inpaintingSettings({{"attribute", std::string("texture")}, {"method", kExemplar}}));
  Progress progress;
  double fraction = 0;
  int steps = 0;
  for (bool isFinished = false; !isFinished; ++steps) {
    const PointSet before = run->result().points;
    CancelAfter cancel(steps % 5);
    try {
      isFinished = run->step(cancel).finished;
      continue;
    } catch (const Cancelled&) {
      EXPECT_TRUE(identical(run->result().points, before));
    }
    const StepState state = run->step(progress);
    isFinished = state.finished;
    EXPECT_GE(state.fraction, fraction);
    fraction = state.fraction;
    for (const Index row : damaged.masked) EXPECT_GE(run->result().points.values<double>("texture")[row], 0);
  }
  EXPECT_GT(steps, 8);
  EXPECT_LT(steps, 30);
  EXPECT_LT(damaged.errorOf(run->result().points), 0.4);
}

}  // namespace
}  // namespace stipple
