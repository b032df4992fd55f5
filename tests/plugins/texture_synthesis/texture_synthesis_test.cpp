#include "plugins/texture_synthesis/texture_synthesis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/plugins/texture_synthesis/grown_patterns.h"
#include "tests/support/creased_shapes.h"
#include "tests/support/shapes.h"

namespace stipple {
namespace {

using testing::Each;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::ThrowsMessage;

const double kSphereArea = 4 * std::numbers::pi;

const AttributeValues& valuesOf(const PointSet& points, const char* name) {
  return points.find(name)->column.values();
}

bool sameSpecies(const PointSet& a, const PointSet& b) {
  for (const char* name : {"species_a", "species_b", "species_c", "species_d", "species_e"}) {
    if (a.has(name) != b.has(name)) return false;
    if (a.has(name) && !sameBits(valuesOf(a, name), valuesOf(b, name))) return false;
  }
  return true;
}

double deviation(std::span<const float> values) {
  double sum = 0, squares = 0;
  for (const float value : values) {
    sum += value;
    squares += static_cast<double>(value) * value;
  }
  const auto count = static_cast<double>(values.size());
  return std::sqrt(std::max(0.0, squares / count - sum * sum / (count * count)));
}

// Distance of spots by their number, over the wanted one.
double relativeDistance(const PointSet& points, const std::string& pattern, double size, double area) {
  const PointSet grown = growPattern(points, {{"pattern", pattern}, {"size", size}});
  const bool isHigh = pattern == "gray_scott" || pattern == "gierer_meinhardt";
  const auto field = grown.values<float>(pattern == "gierer_meinhardt" ? "species_a" : "species_b");
  return hexagonalDistance(area, countSpots(grown, field, isHigh)) / size;
}

TEST(TextureSynthesis, SpotsStandAtTheWantedDistance) {
  const PointSet sphere(fibonacciSphere(12000));
  for (const char* pattern : {"spots", "turk_spots", "gierer_meinhardt"}) {
    EXPECT_NEAR(relativeDistance(sphere, pattern, 0.35, kSphereArea), 1, 0.1) << pattern;
  }
  EXPECT_NEAR(relativeDistance(sphere, "spots", 0.28, kSphereArea), 1, 0.1);
}

TEST(TextureSynthesis, GrayAndScottsSpotsStandAtTheWantedDistance) {
  EXPECT_NEAR(relativeDistance(PointSet(fibonacciSphere(8000)), "gray_scott", 0.4, kSphereArea), 1, 0.1);
}

TEST(TextureSynthesis, SpotsKnowNeitherDensityNorScale) {
  EXPECT_NEAR(relativeDistance(PointSet(fibonacciSphere(36000)), "spots", 0.4, kSphereArea), 1, 0.1);
  EXPECT_NEAR(relativeDistance(PointSet(shapes::randomSphere(9000)), "spots", 0.4, kSphereArea), 1, 0.1);
  for (const float scale : {1e-3f, 1e4f}) {
    std::vector<Eigen::Vector3f> positions = fibonacciSphere(9000);
    for (Eigen::Vector3f& p : positions) p *= scale;
    const double area = kSphereArea * scale * scale;
    EXPECT_NEAR(relativeDistance(PointSet(positions), "spots", 0.4 * scale, area), 1, 0.1) << scale;
  }
}

TEST(TextureSynthesis, StripesStandAtTheWantedDistance) {
  const PointSet grown =
      growPattern(PointSet(fibonacciSphere(12000)), {{"pattern", std::string("stripes")}, {"size", 0.3}});
  EXPECT_NEAR(stripeDistance(grown, grown.values<float>("species_a")) / 0.3, 1, 0.1);
}

TEST(TextureSynthesis, StripesStayBoundedAtAnyTimeStep) {
  const PointSet sphere(fibonacciSphere(1000));
  for (const double dt : {1.0, 2.0, 5.0}) {
    const PointSet grown = growPattern(sphere, {{"pattern", std::string("stripes")},
                                                {"size", 0.8},
                                                {"time_step", dt},
                                                {"steps", std::int64_t{5000}}});
    for (const char* name : {"species_a", "species_b", "species_c", "species_d", "species_e"}) {
      EXPECT_THAT(grown.values<float>(name), Each(testing::AllOf(testing::Ge(0.f), testing::Le(4.f)))) << dt;
    }
    EXPECT_GT(deviation(grown.values<float>("species_a")), 0.3) << dt << ": neither faded nor uniform";
  }
}

TEST(TextureSynthesis, SameBitsForAnyNumberOfThreads) {
  const PointSet sphere(shapes::randomSphere(10000));
  for (const char* pattern : {"spots", "stripes", "gray_scott"}) {
    const auto run = [&](int threads) {
      const ThreadLimit limit(threads);
      return growPattern(sphere,
                         {{"pattern", std::string(pattern)}, {"size", 0.5}, {"steps", std::int64_t{20}}});
    };
    EXPECT_TRUE(sameSpecies(run(1), run(4))) << pattern;
  }
}

TEST(TextureSynthesis, TheSeedDecides) {
  const PointSet sphere(fibonacciSphere(3000));
  const auto run = [&](std::int64_t seed) {
    return growPattern(sphere, {{"seed", seed}, {"steps", std::int64_t{30}}, {"size", 0.6}});
  };
  EXPECT_TRUE(sameSpecies(run(7), run(7)));
  EXPECT_FALSE(sameSpecies(run(7), run(8)));
}

TEST(TextureSynthesis, GoingOnEqualsARunWithoutAPause) {
  const PointSet sphere(shapes::randomSphere(4000));
  for (const char* pattern : {"spots", "stripes", "gray_scott", "gierer_meinhardt"}) {
    const auto run = [&](const PointSet& points, std::int64_t steps, bool resume) {
      return growPattern(
          points, {{"pattern", std::string(pattern)}, {"size", 0.7}, {"steps", steps}, {"resume", resume}});
    };
    const PointSet whole = run(sphere, 50, false), half = run(sphere, 25, false);
    EXPECT_FALSE(sameSpecies(whole, half)) << pattern;
    EXPECT_TRUE(sameSpecies(whole, run(half, 25, true))) << pattern;
  }
}

TEST(TextureSynthesis, SettingWhatIsSetChangesNothing) {
  const PointSet sphere(fibonacciSphere(3000));
  const Parameters settings = textureSettings({{"size", 0.6}, {"steps", std::int64_t{40}}});
  const auto run = makeTextureSynthesis()->start(sphere, Region(), settings);
  Progress progress;
  EXPECT_FALSE(run->result().points.has("species_a")) << "the snapshot before the first step";
  for (int step = 1; step <= 40; ++step) {
    run->set(settings);
    const StepState state = run->step(progress);
    EXPECT_EQ(state.finished, step == 40);
    EXPECT_DOUBLE_EQ(state.fraction, step / 40.0);
    EXPECT_GT(state.curve.value(), 0);
  }
  const PointSet whole = growPattern(sphere, {{"size", 0.6}, {"steps", std::int64_t{40}}});
  EXPECT_TRUE(sameSpecies(run->result().points, whole));

  // More steps go on from here.
  run->set(textureSettings({{"size", 0.6}, {"steps", std::int64_t{50}}}));
  while (!run->step(progress).finished) {
  }
  const PointSet longer = growPattern(sphere, {{"size", 0.6}, {"steps", std::int64_t{50}}});
  EXPECT_TRUE(sameSpecies(run->result().points, longer));
}

TEST(TextureSynthesis, ParametersActAtTheNextStep) {
  const PointSet sphere(fibonacciSphere(3000));
  const std::int64_t steps = 300;
  const auto run =
      makeTextureSynthesis()->start(sphere, Region(), textureSettings({{"size", 0.6}, {"steps", steps}}));
  Progress progress;
  for (int step = 0; step < 100; ++step) run->step(progress);
  const PointSet before = run->result().points;
  run->set(textureSettings({{"size", 0.9}, {"steps", steps}}));
  const StepState state = run->step(progress);
  EXPECT_DOUBLE_EQ(state.fraction, 101.0 / 300) << "it goes on";
  EXPECT_FALSE(sameSpecies(before, run->result().points));

  // Another pattern of the same substances goes on, one of others starts anew.
  run->set(textureSettings({{"size", 0.9}, {"steps", steps}, {"pattern", std::string("turk_spots")}}));
  EXPECT_DOUBLE_EQ(run->step(progress).fraction, 102.0 / 300);
  run->set(textureSettings({{"size", 0.9}, {"steps", steps}, {"pattern", std::string("stripes")}}));
  EXPECT_DOUBLE_EQ(run->step(progress).fraction, 1.0 / 300);
  EXPECT_TRUE(run->result().points.has("species_e"));
}

TEST(TextureSynthesis, RefusedParametersLeaveTheRunAsItWas) {
  const auto run = makeTextureSynthesis()->start(PointSet(fibonacciSphere(3000)), Region(),
                                                 textureSettings({{"size", 0.6}}));
  Progress progress;
  run->step(progress);
  EXPECT_THROW(run->set(textureSettings({{"size", 0.6}, {"time_step", 90.0}})), InvalidInput);
  EXPECT_DOUBLE_EQ(run->step(progress).fraction, 2.0 / 1000);
}

class Stopped final : public Progress {
 public:
  bool cancelled() const override { return true; }
};

TEST(TextureSynthesis, ACancelledStepLeavesTheOneBefore) {
  const auto run = makeTextureSynthesis()->start(PointSet(fibonacciSphere(3000)), Region(),
                                                 textureSettings({{"size", 0.6}}));
  Stopped stopped;
  EXPECT_THROW(run->step(stopped), Cancelled);
  EXPECT_FALSE(run->result().points.has("species_a"));
  Progress progress;
  run->step(progress);
  const PointSet before = run->result().points;
  EXPECT_THROW(run->step(stopped), Cancelled);
  EXPECT_TRUE(sameSpecies(before, run->result().points));
}

TEST(TextureSynthesis, ZebraSpreadsInRingsFromItsSeeds) {
  constexpr int kSide = 81, kMiddle = kSide / 2;
  PointSet points(shapes::grid(kSide));
  std::vector<std::int32_t> seeds(points.size(), 0);
  seeds[kMiddle * kSide + kMiddle] = 1;
  points.set("marks", seeds);
  const PointSet grown = growPattern(points, {{"pattern", std::string("zebra")},
                                              {"seeds", std::string("marks")},
                                              {"size", 0.15},
                                              {"steps", std::int64_t{200}}});
  const auto a = grown.values<float>("species_a");
  // Turned by 90 degrees it is the same, up to what grows out of rounding.
  double difference = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double change = a[static_cast<std::size_t>(y * kSide + x)] -
                            a[static_cast<std::size_t>(x * kSide + (kSide - 1 - y))];
      difference += change * change;
    }
  }
  EXPECT_LT(std::sqrt(difference / (kSide * kSide)), 0.1 * deviation(a));
  // Along a ray from the middle, light and dark take turns: one ring in a size of 12 points.
  int changes = 0;
  for (int x = kMiddle + 1; x < kMiddle + 30; ++x) {
    const auto at = [&](int column) { return a[static_cast<std::size_t>(kMiddle * kSide + column)] > 0.75f; };
    if (at(x) != at(x - 1)) ++changes;
  }
  EXPECT_GE(changes, 3);
  EXPECT_LE(changes, 7);
}

TEST(TextureSynthesis, ZebraStartsAtEdges) {
  const shapes::FacedPoints cube = shapes::randomCube(12000, 1);
  const auto run = makeTextureSynthesis()->start(
      PointSet(cube.positions), Region(),
      textureSettings({{"pattern", std::string("zebra")}, {"size", 0.2}, {"time_step", 0.01}}));
  Progress progress;
  run->step(progress);
  const PointSet started = run->result().points;
  const auto a = started.values<float>("species_a");
  // Radius of a neighborhood of 30: sqrt(30 / pi) spacings, and a little.
  const float reach = 1.15f * std::sqrt(30.f / std::numbers::pi_v<float> * 6 / 12000);
  int seeds = 0, away = 0;
  for (Index i = 0; i < started.size(); ++i) {
    if (a[i] < 0.85f) continue;
    ++seeds;
    // Two of the coordinates of a point at an edge lie at the border.
    const Eigen::Array3f p = started.positions()[i].array();
    const Eigen::Array3f room = (p - p.floor()).min(p.ceil() - p);
    if ((room < reach).count() < 2) ++away;
  }
  EXPECT_GT(seeds, 100);
  EXPECT_LT(away, seeds / 20);
}

TEST(TextureSynthesis, TheSizeFollowsAnAttribute) {
  PointSet sphere(fibonacciSphere(24000));
  std::vector<float> doublings(sphere.size());
  for (Index i = 0; i < sphere.size(); ++i) doublings[i] = sphere.positions()[i].z() > 0 ? 1.f : 0.f;
  sphere.set("doublings", doublings);
  const PointSet grown = growPattern(sphere, {{"size", 0.22}, {"size_by", std::string("doublings")}});
  std::vector<Eigen::Vector3f> halves[2];
  std::vector<float> values[2];
  const auto b = grown.values<float>("species_b");
  for (Index i = 0; i < grown.size(); ++i) {
    const int half = grown.positions()[i].z() > 0 ? 1 : 0;
    halves[half].push_back(grown.positions()[i]);
    values[half].push_back(b[i]);
  }
  const int small = countSpots(PointSet(halves[0]), values[0], false);
  const int large = countSpots(PointSet(halves[1]), values[1], false);
  // Four times as many, less what lies across the border.
  EXPECT_NEAR(static_cast<double>(small) / large, 4, 1);
}

TEST(TextureSynthesis, ThePatternFollowsADirection) {
  constexpr int kSide = 101;
  PointSet square(shapes::grid(kSide));
  square.set("along", std::vector<Eigen::Vector3f>(square.size(), Eigen::Vector3f(1, 0, 1)));
  const PointSet grown = growPattern(
      square, {{"size", 0.12}, {"direction_by", std::string("along")}, {"steps", std::int64_t{600}}});
  const auto b = grown.values<float>("species_b");
  double alongSquares = 0, acrossSquares = 0;
  for (std::size_t y = 0; y + 1 < kSide; ++y) {
    for (std::size_t x = 0; x + 1 < kSide; ++x) {
      const float value = b[y * kSide + x];
      alongSquares += std::pow(b[y * kSide + x + 1] - value, 2);
      acrossSquares += std::pow(b[(y + 1) * kSide + x] - value, 2);
    }
  }
  // Length 1 in the plane draws out to twice the width, and gradients follow.
  EXPECT_NEAR(std::sqrt(acrossSquares / alongSquares), 2, 0.4);
}

TEST(TextureSynthesis, ColorsAreWrittenOnRequest) {
  const PointSet sphere(fibonacciSphere(3000));
  const Settings settings = {{"size", 0.6},
                             {"color", true},
                             {"color_ground", std::string("#ffffff")},
                             {"color_figure", std::string("#000000")}};
  const PointSet grown = growPattern(sphere, settings);
  const auto colors = grown.values<Rgba8>("color");
  const auto b = grown.values<float>("species_b");
  for (Index i = 0; i < grown.size(); ++i) {
    EXPECT_EQ(colors[i].r, colors[i].b);
    if (b[i] < 0.01f) {
      EXPECT_EQ(colors[i].r, 0) << "spots are where b is low";
    }
  }
  EXPECT_FALSE(growPattern(sphere, {{"size", 0.6}, {"steps", std::int64_t{1}}}).has("color"));
}

TEST(TextureSynthesis, CopiesOfAPlaceAreAlike) {
  std::vector<Eigen::Vector3f> positions = fibonacciSphere(2000);
  const std::vector<Eigen::Vector3f> once = positions;
  positions.insert(positions.end(), once.begin(), once.end());
  const PointSet grown = growPattern(PointSet(positions), {{"size", 0.8}, {"steps", std::int64_t{50}}});
  const auto a = grown.values<float>("species_a");
  for (std::size_t i = 0; i < once.size(); ++i) EXPECT_EQ(a[i], a[i + once.size()]);
}

void expectRefusal(const PointSet& points, const Settings& settings, const std::string& sentence) {
  EXPECT_THAT([&] { growPattern(points, settings); }, ThrowsMessage<InvalidInput>(HasSubstr(sentence)));
}

TEST(TextureSynthesis, SaysWhyAPatternCannotForm) {
  const PointSet sphere(fibonacciSphere(2000));
  expectRefusal(sphere, {{"size", 0.1}}, "too fine for these points: at least 0.35");
  expectRefusal(sphere, {{"size", 5.0}}, "cannot form on a surface of area");
  expectRefusal(sphere, {{"time_step", 25.0}}, "would be unstable with a time step of 25: at most 20");
  expectRefusal(sphere, {{"time_step", 5.0}, {"pattern", std::string("gray_scott")}}, "at most 4");
  expectRefusal(sphere, {{"pattern", std::string("zebra")}}, "the surface has no edges");
  expectRefusal(sphere, {{"resume", true}}, "needs the attribute \"species_a\"");
  expectRefusal(sphere, {{"size_by", std::string("weights")}}, "no attribute \"weights\"");
  expectRefusal(sphere, {{"color_ground", std::string("red")}}, "expected a color such as");
  PointSet marked = sphere;
  marked.set("marks", std::vector<std::int32_t>(sphere.size(), 0));
  expectRefusal(marked, {{"pattern", std::string("zebra")}, {"seeds", std::string("marks")}},
                "holds no seed");
  expectRefusal(marked, {{"direction_by", std::string("marks")}}, "must be a vector");
}

TEST(TextureSynthesis, DegenerateSetsAreRefusedInOneSentence) {
  expectRefusal(PointSet(std::vector<Eigen::Vector3f>{{1, 2, 3}}), {}, "a pattern needs a surface");
  expectRefusal(PointSet(std::vector<Eigen::Vector3f>(50, Eigen::Vector3f(1, 1, 1))), {}, "needs a surface");
  std::vector<Eigen::Vector3f> line;
  for (int i = 0; i < 30; ++i) line.emplace_back(static_cast<float>(i), 0.f, 0.f);
  EXPECT_THROW(growPattern(PointSet(line), {}), InvalidInput);
  EXPECT_THROW(growPattern(PointSet(shapes::grid(3)), {}), InvalidInput);
}

TEST(TextureSynthesis, DeclaresWhatTheContractPromises) {
  const auto made = makeTextureSynthesis();
  const OperatorDescription& description = made->description();
  EXPECT_EQ(description.id, "texture_synthesis");
  EXPECT_EQ(description.region, RegionUse::kNone);
  std::vector<std::string> ids;
  for (const Parameter& parameter : description.parameters) ids.push_back(parameter.id);
  EXPECT_THAT(ids, IsSupersetOf({"pattern", "size", "steps", "time_step", "seed", "resume", "size_by",
                                 "direction_by", "seed_fraction", "scheme", "metric", "consensus"}));
  std::vector<std::string> patterns;
  for (const Choice& choice : description.parameters.front().choices) patterns.push_back(choice.id);
  EXPECT_THAT(patterns, testing::ElementsAre("spots", "turk_spots", "stripes", "zebra", "gray_scott",
                                             "gierer_meinhardt"));
  EXPECT_NO_THROW(checkDeclarations(description.parameters));
}

}  // namespace
}  // namespace stipple
