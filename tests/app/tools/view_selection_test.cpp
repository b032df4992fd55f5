#include "app/tools/view_selection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "core/error.h"
#include "tests/app/tools/pick_scene.h"

namespace stipple {
namespace {

/// Random points on a near strip, x < 0, and on a far one below all of it; and what the picture shows.
class ViewSelectionTest : public testing::Test {
 protected:
  ViewSelectionTest() {
    scene_.strips = {{.height = 0.5f, .right = 0}, {.height = 0, .slope = 0.3f}};
    std::mt19937 random(1);
    std::uniform_real_distribution<float> uniform(-1.5f, 1.5f);
    for (int i = 0; i < 40000; ++i) {
      const float x = uniform(random), y = uniform(random);
      const bool isNear = i % 2 == 0 && x < 0;
      positions_.emplace_back(x, y, isNear ? 0.5f : 0.3f * x);
      isHidden_.push_back(shows(positions_.back()).z > positions_.back().z() + 0.1f);
    }
    depth_.assign(std::size_t{800} * 600, std::numeric_limits<float>::infinity());
    for (int y = 0; y < 600; ++y) {
      for (int x = 0; x < 800; ++x) {
        const auto hit = scene_.pickAt({x, y});
        if (hit) depth_[static_cast<std::size_t>(y) * 800 + static_cast<std::size_t>(x)] = hit->depth;
      }
    }
  }

  // The place that the picture shows where this one would be.
  glm::vec3 shows(const Eigen::Vector3f& p) const {
    const auto hit = scene_.pickAt(pixelOf(p));
    return hit ? hit->position : glm::vec3{};
  }
  glm::vec2 pixelOf(const Eigen::Vector3f& p) const { return scene_.pixelOf({p.x(), p.y(), p.z()}); }
  SeenPoints seen() const {
    return {.positions = positions_, .view = scene_.view, .depth = depth_, .tolerance = 0.02f};
  }
  SeenPoints through() const { return {.positions = positions_, .view = scene_.view}; }

  template <class Within>
  std::vector<Index> expected(bool visible, const Within& within) const {
    std::vector<Index> rows;
    for (Index row = 0; row < positions_.size(); ++row) {
      const glm::vec2 px = pixelOf(positions_[row]);
      const bool isInside = px.x >= 0 && px.y >= 0 && px.x < 800 && px.y < 600;
      if (isInside && within(px) && !(visible && isHidden_[row])) rows.push_back(row);
    }
    return rows;
  }

  PickScene scene_;
  std::vector<Eigen::Vector3f> positions_;
  std::vector<bool> isHidden_;
  std::vector<float> depth_;
};

TEST_F(ViewSelectionTest, ARectangleTakesWhatIsSeenInIt) {
  const ScreenRectangle rectangle{{500, 120.5f}, {190, 470}};  // corners in any order
  const auto within = [](const glm::vec2& px) {
    return px.x >= 190 && px.x <= 500 && px.y >= 120.5f && px.y <= 470;
  };
  const std::vector<Index> rows = findInRectangle(seen(), rectangle);
  EXPECT_EQ(rows, expected(true, within));
  EXPECT_EQ(findInRectangle(through(), rectangle), expected(false, within));
  EXPECT_GT(findInRectangle(through(), rectangle).size(), rows.size() + 1000);
}

TEST_F(ViewSelectionTest, ALassoIsEvenOdd) {
  // A star of five points drawn in one go: its middle is outside.
  std::vector<glm::vec2> star;
  for (int corner = 0; corner < 5; ++corner) {
    const float angle = static_cast<float>(corner) * 2.5132741f;
    star.emplace_back(400 + 250 * std::cos(angle), 300 + 250 * std::sin(angle));
  }
  const auto within = [&](const glm::vec2& px) {
    const glm::vec2 c = glm::floor(px) + 0.5f;
    int crossed = 0;
    for (std::size_t i = 0; i < 5; ++i) {
      const glm::dvec2 a = star[i], b = star[(i + 1) % 5];
      if ((a.y > c.y) == (b.y > c.y)) continue;
      crossed += a.x + (c.y - a.y) / (b.y - a.y) * (b.x - a.x) > c.x;
    }
    return crossed % 2 == 1;
  };
  const std::vector<Index> rows = findInLasso(seen(), star);
  EXPECT_EQ(rows, expected(true, within));
  EXPECT_GT(rows.size(), 500u);
  for (const Index row : rows) EXPECT_GT(glm::distance(pixelOf(positions_[row]), {400, 300}), 76);
}

TEST_F(ViewSelectionTest, ALassoMayLeaveThePicture) {
  const std::vector<glm::vec2> everything{{-1e6f, -1e6f}, {1e6f, -1e6f}, {1e6f, 1e6f}, {-1e6f, 1e6f}};
  EXPECT_EQ(findInLasso(seen(), everything), expected(true, [](const glm::vec2&) { return true; }));
  EXPECT_THAT(findInLasso(seen(), std::vector<glm::vec2>{{0, 0}, {800, 600}}), testing::IsEmpty());
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT(findInLasso(seen(), std::vector<glm::vec2>{{0, 0}, {800, 600}, {nan, 0}}), testing::IsEmpty());
}

TEST_F(ViewSelectionTest, AClickTakesTheNearestThatIsSeen) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> x(100, 700), y(50, 550);
  for (int i = 0; i < 50; ++i) {
    const glm::vec2 px(x(random), y(random));
    const auto candidates = expected(true, [&](const glm::vec2& at) { return glm::distance(at, px) <= 10; });
    const std::optional<Index> row = findClicked(seen(), px, 10);
    ASSERT_EQ(row.has_value(), !candidates.empty());
    if (!row) continue;
    float least = 100;
    for (const Index c : candidates) least = std::min(least, glm::distance(pixelOf(positions_[c]), px));
    EXPECT_NEAR(glm::distance(pixelOf(positions_[*row]), px), least, 1e-3f);
    EXPECT_FALSE(isHidden_[*row]);
  }
  EXPECT_FALSE(findClicked(seen(), {5, 5}, 0));
}

TEST_F(ViewSelectionTest, TakesNothingBehindTheEyeOrWithoutAPlace) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  positions_ = {{0, 0, 5}, {nan, 0, 0}, {0, 0, nan}, {0.1f, 0, 0.03f}};
  EXPECT_THAT(findInRectangle(through(), {{0, 0}, {800, 600}}), testing::ElementsAre(3));
  positions_.clear();
  EXPECT_THAT(findInRectangle(through(), {{0, 0}, {800, 600}}), testing::IsEmpty());
  EXPECT_FALSE(findClicked(through(), {400, 300}));
}

TEST_F(ViewSelectionTest, TheDepthMustBeThatOfThePicture) {
  depth_.pop_back();
  EXPECT_THROW(findInRectangle(seen(), {{0, 0}, {800, 600}}), InvalidInput);
  EXPECT_THROW(findClicked(seen(), {400, 300}), InvalidInput);
}

}  // namespace
}  // namespace stipple
