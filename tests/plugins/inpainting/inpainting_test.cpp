#include "plugins/inpainting/inpainting.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/plugins/inpainting/inpaint_points.h"
#include "tests/support/cancel_after.h"
#include "tests/support/identical.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::ThrowsMessage;

constexpr Rgba8 kSkin{224, 172, 140, 255}, kTrousers{20, 22, 30, 255}, kBlack{0, 0, 0, 255};

// A flat place with a straight edge of color, as between trousers and leg, and a hole across it.
struct Trousers {
  PointSet points{shapes::randomSquare(10000, 7)};
  std::vector<Index> masked = rowsAround(points, {0.5f, 0.5f, 0}, 0.12f);

  Trousers() {
    std::vector<Rgba8> colors;
    for (const Eigen::Vector3f& p : points.positions()) colors.push_back(isSkin(p) ? kSkin : kTrousers);
    for (const Index row : masked) colors[row] = kBlack;
    points.set("color", colors);
  }
  static float distanceToEdge(const Eigen::Vector3f& p) {
    return 0.9f * (p.y() - 0.52f) + 0.436f * (p.x() - 0.5f);
  }
  static bool isSkin(const Eigen::Vector3f& p) { return distanceToEdge(p) > 0; }

  // Share of the hole, farther than `spacings` from the edge, that is nearer to the other color.
  double bleeding(const PointSet& filled, float spacings) const {
    double wrong = 0, all = 0;
    for (const Index row : masked) {
      const Eigen::Vector3f& p = points.positions()[row];
      if (std::abs(distanceToEdge(p)) < spacings / 100) continue;
      ++all;
      if ((filled.values<Rgba8>("color")[row].r > (kSkin.r + kTrousers.r) / 2) != isSkin(p)) ++wrong;
    }
    return wrong / all;
  }
};

TEST(Inpainting, TrousersDoNotBleedOntoTheLeg) {
  const Trousers trousers;
  const PointSet tensor = inpaint(trousers.points, trousers.masked, {});
  EXPECT_EQ(trousers.bleeding(tensor, 2), 0);
  // Within 4 spacings of the edge, the colors are nearly those of the two sides.
  int pure = 0, all = 0;
  for (const Index row : trousers.masked) {
    const Eigen::Vector3f& p = trousers.points.positions()[row];
    if (std::abs(Trousers::distanceToEdge(p)) < 0.04f) continue;
    const Rgba8 wanted = Trousers::isSkin(p) ? kSkin : kTrousers;
    ++all;
    if (std::abs(tensor.values<Rgba8>("color")[row].r - wanted.r) < 25) ++pure;
  }
  EXPECT_GT(pure, 0.95 * all);
}

TEST(Inpainting, KnownPointsKeepTheirBits) {
  const Trousers trousers;
  for (const char* method : {"tensor", "harmonic", "biharmonic", "exemplar"}) {
    PointSet filled = inpaint(trousers.points, trousers.masked, {{"method", std::string(method)}});
    for (const Index row : trousers.masked) {
      EXPECT_NE(filled.values<Rgba8>("color")[row], kBlack);
      filled.edit<Rgba8>("color")[row] = kBlack;
    }
    EXPECT_TRUE(identical(filled, trousers.points)) << method;
  }
}

TEST(Inpainting, HarmonicFillsStayBetweenTheValuesOfTheRim) {
  PointSet points(shapes::randomSphere(8000, 5));
  std::vector<double> values;
  for (const Eigen::Vector3f& p : points.positions()) values.push_back(std::sin(9 * p.x()) * p.y());
  const std::vector<Index> masked = rowsAround(points, {0, 0, 1}, 0.3f);
  double least = 1, greatest = -1;
  for (const Index row : rowsAround(points, {0, 0, 1}, 0.5f)) {
    if (std::ranges::binary_search(masked, row)) continue;
    least = std::min(least, values[row]);
    greatest = std::max(greatest, values[row]);
  }
  for (const Index row : masked) values[row] = 50;
  points.set("wave", values);
  const PointSet filled =
      inpaint(points, masked, {{"attribute", std::string("wave")}, {"method", std::string("harmonic")}});
  for (const Index row : masked) {
    EXPECT_GE(filled.values<double>("wave")[row], least);
    EXPECT_LE(filled.values<double>("wave")[row], greatest);
  }
}

TEST(Inpainting, APartWithoutRimTakesTheNearestValueAndIsReported) {
  std::vector<Eigen::Vector3f> positions = shapes::grid(40);
  for (const Eigen::Vector3f& p : shapes::grid(12)) positions.push_back(0.3f * p + Eigen::Vector3f(4, 0, 3));
  PointSet points(positions);
  std::vector<float> heights;
  for (const Eigen::Vector3f& p : positions) heights.push_back(p.y());
  std::vector<Index> masked = rowsAround(points, {0.3f, 0.5f, 0}, 0.1f);
  for (Index row = 1600; row < points.size(); ++row) {
    masked.push_back(row);
    heights[row] = -7;
  }
  points.set("height", heights);
  for (const char* method : {"tensor", "harmonic", "biharmonic", "exemplar"}) {
    Report report;
    const PointSet filled = inpaint(
        points, masked, {{"attribute", std::string("height")}, {"method", std::string(method)}}, &report);
    ASSERT_EQ(report.warnings.size(), 1u);
    EXPECT_THAT(report.warnings.front(), HasSubstr("144 points"));
    // Nearest is the edge x = 1 of the large square, at the same height.
    for (Index row = 1600; row < points.size(); ++row)
      EXPECT_NEAR(filled.values<float>("height")[row], positions[row].y(), 0.5f / 39 + 1e-5f);
  }
}

TEST(Inpainting, CopiesOfAPlaceAgree) {
  std::vector<Eigen::Vector3f> positions = shapes::grid(30);
  positions.insert(positions.end(), positions.begin(), positions.end());
  PointSet points(positions);
  std::vector<float> heights;
  for (const Eigen::Vector3f& p : positions) heights.push_back(p.x());
  const std::vector<Index> both = rowsAround(points, {0.5f, 0.5f, 0}, 0.2f);
  std::vector<Index> masked = both;
  // A place of which one copy is known is known.
  const Index half = both.back();
  std::erase(masked, half - 900);
  heights[half - 900] = heights[half] = 0.9f;
  points.set("height", heights);
  const PointSet filled = inpaint(points, masked, {{"attribute", std::string("height")}});
  const auto found = filled.values<float>("height");
  for (const Index row : both) EXPECT_EQ(found[row], found[row < 900 ? row + 900 : row - 900]);
  EXPECT_EQ(found[half], 0.9f);
}

TEST(Inpainting, ValuesThatAreNoneNeitherSpreadNorChange) {
  PointSet points(shapes::grid(30));
  std::vector<float> values(900, 2.f);
  values[15 * 30 + 10] = std::numeric_limits<float>::quiet_NaN();
  points.set("value", values);
  const std::vector<Index> masked{15 * 30 + 11, 15 * 30 + 12};
  const PointSet filled = inpaint(points, masked, {{"attribute", std::string("value")}});
  EXPECT_TRUE(std::isnan(filled.values<float>("value")[15 * 30 + 10]));
  EXPECT_NEAR(filled.values<float>("value")[15 * 30 + 11], 2, 1e-5);
}

TEST(Inpainting, UnitVectorsStayUnit) {
  PointSet points(shapes::randomSphere(5000, 2));
  std::vector<Eigen::Vector3f> normals(points.positions().begin(), points.positions().end());
  const std::vector<Index> masked = rowsAround(points, {0, 0, 1}, 0.3f);
  for (const Index row : masked) normals[row].setZero();
  points.set("normal", normals);
  const PointSet filled = inpaint(points, masked, {{"attribute", std::string("normal")}});
  for (const Index row : masked) {
    EXPECT_NEAR(filled.values<Eigen::Vector3f>("normal")[row].norm(), 1, 1e-5);
    EXPECT_GT(filled.values<Eigen::Vector3f>("normal")[row].dot(points.positions()[row]), 0.97);
  }
}

TEST(Inpainting, StepsCancelAndTakeNewParameters) {
  const Trousers trousers;
  const auto run = makeInpainting()->start(trousers.points, regionOfRows(trousers.points, trousers.masked),
                                           inpaintingSettings({{"method", std::string("harmonic")}}));
  CancelAfter cancel(0);
  EXPECT_THROW(run->step(cancel), Cancelled);
  EXPECT_TRUE(identical(run->result().points, trousers.points));
  Progress progress;
  const StepState first = run->step(progress);
  EXPECT_FALSE(first.finished);
  EXPECT_GT(*first.curve, 0);
  int steps = 1;
  while (!run->step(progress).finished) ++steps;
  EXPECT_GT(steps, 5);
  EXPECT_LT(steps, 30);
  run->set(inpaintingSettings({}));
  while (!run->step(progress).finished) {
  }
  EXPECT_TRUE(identical(run->result().points, inpaint(trousers.points, trousers.masked, {})));
}

TEST(Inpainting, SameBitsForAnyNumberOfThreads) {
  const Trousers trousers;
  const auto filled = [&](int threads) {
    const ThreadLimit limit(threads);
    return inpaint(trousers.points, trousers.masked, {});
  };
  EXPECT_TRUE(identical(filled(1), filled(4)));
}

TEST(Inpainting, SaysWhatItCannotDo) {
  PointSet points(shapes::grid(6));
  EXPECT_THAT([&] { inpaint(points, {1}, {}); },
              ThrowsMessage<InvalidInput>(HasSubstr("no attribute \"color\"")));
  points.set("color", std::vector<Rgba8>(36));
  std::vector<Index> all(36);
  for (Index row = 0; row < 36; ++row) all[row] = row;
  EXPECT_THAT([&] { inpaint(points, all, {}); }, ThrowsMessage<InvalidInput>(HasSubstr("outside the mask")));
  Report report;
  EXPECT_TRUE(identical(inpaint(points, {}, {}, &report), points));
  EXPECT_THAT(report.warnings.at(0), HasSubstr("empty"));
}

TEST(Inpainting, DegenerateSetsEndQuietly) {
  for (const auto& positions :
       {std::vector<Eigen::Vector3f>{{0, 0, 0}, {1, 0, 0}}, std::vector<Eigen::Vector3f>(20, {1, 1, 1}),
        std::vector<Eigen::Vector3f>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {4, 0, 0}}}) {
    PointSet points(positions);
    points.set("color", std::vector<Rgba8>(positions.size(), kSkin));
    points.edit<Rgba8>("color")[1] = kBlack;
    for (const char* method : {"tensor", "harmonic", "biharmonic", "exemplar"})
      EXPECT_EQ(inpaint(points, {1}, {{"method", std::string(method)}}).values<Rgba8>("color")[1], kSkin);
  }
}

TEST(Inpainting, DeclaresWhatTheContractPromises) {
  const auto inpainting = makeInpainting();
  const OperatorDescription& description = inpainting->description();
  EXPECT_EQ(description.id, "inpainting");
  EXPECT_EQ(description.region, RegionUse::kMask);
  EXPECT_TRUE(description.runsAtEndOfStroke);
  EXPECT_EQ(description.paintable.at(0).attribute, "mask");
  std::vector<std::string> ids;
  for (const Parameter& parameter : description.parameters) ids.push_back(parameter.id);
  EXPECT_THAT(ids, IsSupersetOf({"attribute", "method", "scheme", "metric", "consensus"}));
  EXPECT_NO_THROW(checkDeclarations(description.parameters));
}

}  // namespace
}  // namespace stipple
