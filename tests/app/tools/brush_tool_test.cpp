#include "app/tools/brush_tool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/tools/pick_scene.h"

namespace stipple {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

/// A plane whose right quarter is missing; file coordinates begin at (1000, 2000, 3000).
class BrushToolTest : public testing::Test {
 protected:
  BrushToolTest() {
    scene_.strips = {{.right = 0.8f}};
    settings_.radiusUnit = RadiusUnit::kModel;
    settings_.radius = 0.2;
    tool_.set(settings_);
  }

  BrushResponse send(const PointerEvent& event) {
    return tool_.handle(event, {.view = scene_.view, .pickAt = pickAt_, .origin = kOrigin, .emptyDepth = 4});
  }
  BrushResponse press(const glm::vec2& px, Modifiers modifiers = {}, float pressure = 1) {
    return send({.action = PointerAction::kPress,
                 .px = px,
                 .button = PointerButton::kLeft,
                 .modifiers = modifiers,
                 .pressure = pressure});
  }
  BrushResponse move(const glm::vec2& px, float pressure = 1) {
    return send({.px = px, .pressure = pressure});
  }
  BrushResponse release(const glm::vec2& px) {
    return send({.action = PointerAction::kRelease, .px = px, .button = PointerButton::kLeft, .pressure = 0});
  }
  BrushCanvas canvas() const {
    return {.view = scene_.view, .pickAt = pickAt_, .origin = kOrigin, .emptyDepth = 4};
  }

  const Eigen::Vector3d kOrigin{1000, 2000, 3000};
  const glm::vec2 kOn{300, 300}, kBeside{780, 300};
  PickScene scene_;
  PickAt pickAt_ = scene_.picker();
  BrushSettings settings_;
  BrushTool tool_;
};

TEST_F(BrushToolTest, PaintsOnTheSurfaceFromPressToRelease) {
  const BrushResponse begun = press(kOn);
  EXPECT_TRUE(begun.taken);
  EXPECT_EQ(begun.phase, StrokePhase::kBegins);
  ASSERT_THAT(begun.dabs, SizeIs(1));
  const glm::vec3 hit = scene_.pickAt(kOn)->position;
  EXPECT_LT((begun.dabs[0].position - kOrigin - Eigen::Vector3d(hit.x, hit.y, hit.z)).norm(), 1e-6);
  EXPECT_EQ(begun.dabs[0].pressure, 1);
  EXPECT_EQ(tool_.stroke().kind, BrushKind::kPaint);
  EXPECT_EQ(tool_.stroke().stroke.attribute, "color");
  EXPECT_EQ(tool_.stroke().stroke.value, settings_.value);
  EXPECT_EQ(tool_.stroke().stroke.radius, 0.2);
  EXPECT_THAT(tool_.stroke().stroke.dabs, IsEmpty());

  const BrushResponse moved = move({500, 300});
  EXPECT_TRUE(moved.taken);
  EXPECT_EQ(moved.phase, StrokePhase::kGoesOn);
  EXPECT_GT(moved.dabs.size(), 5u);
  const BrushResponse ended = release({500, 300});
  EXPECT_TRUE(ended.taken);
  EXPECT_EQ(ended.phase, StrokePhase::kEnds);
  EXPECT_FALSE(tool_.isStroking());
  EXPECT_EQ(move({510, 300}).phase, StrokePhase::kNone);
}

TEST_F(BrushToolTest, LeavesTheRestToTheCamera) {
  EXPECT_FALSE(press(kBeside).taken);
  EXPECT_FALSE(tool_.isStroking());
  EXPECT_FALSE(press(kOn, {.alt = true}).taken);
  EXPECT_FALSE(send({.action = PointerAction::kPress, .px = kOn, .button = PointerButton::kMiddle}).taken);
  EXPECT_FALSE(send({.action = PointerAction::kWheel, .px = kOn, .wheelSteps = 1}).taken);
  EXPECT_FALSE(move(kOn).taken);
  EXPECT_FALSE(release(kOn).taken);
}

TEST_F(BrushToolTest, AStrokeOutlivesTheRimAndOtherButtons) {
  press(kOn);
  EXPECT_TRUE(move(kBeside).taken);
  EXPECT_TRUE(send({.action = PointerAction::kPress, .px = kOn, .button = PointerButton::kRight}).taken);
  EXPECT_TRUE(send({.action = PointerAction::kLeave, .px = kOn}).taken);
  EXPECT_TRUE(tool_.isStroking());
  EXPECT_THAT(move({780, 320}).dabs, IsEmpty());
  EXPECT_FALSE(move(kOn).dabs.empty());
}

TEST_F(BrushToolTest, TheReleaseEndsTheWayWithTheLastPressure) {
  settings_.pressure = PressureMapping::kStrength;
  tool_.set(settings_);
  press(kOn, {}, 0.5f);
  const BrushResponse ended = release({500, 300});
  ASSERT_GT(ended.dabs.size(), 5u);
  for (const Dab& dab : ended.dabs) EXPECT_FLOAT_EQ(static_cast<float>(dab.pressure), 0.5f);
}

TEST_F(BrushToolTest, ADoubleClickIsAStrokeToo) {
  const PointerEvent twice{.action = PointerAction::kDoubleClick, .px = kOn, .button = PointerButton::kLeft};
  EXPECT_EQ(send(twice).phase, StrokePhase::kBegins);
}

TEST_F(BrushToolTest, CtrlInvertsAndShiftSmooths) {
  const auto kindWith = [&](BrushKind kind, Modifiers modifiers) {
    settings_.kind = kind;
    tool_.set(settings_);
    press(kOn, modifiers);
    release(kOn);
    return tool_.stroke().kind;
  };
  EXPECT_EQ(kindWith(BrushKind::kPaint, {.ctrl = true}), BrushKind::kErase);
  EXPECT_EQ(tool_.stroke().stroke.tool, StrokeTool::kErase);
  EXPECT_EQ(kindWith(BrushKind::kErase, {}), BrushKind::kErase);
  EXPECT_EQ(kindWith(BrushKind::kErase, {.ctrl = true}), BrushKind::kPaint);
  EXPECT_EQ(kindWith(BrushKind::kPaint, {.shift = true}), BrushKind::kSmooth);
  EXPECT_EQ(kindWith(BrushKind::kSmooth, {.ctrl = true}), BrushKind::kSmooth);
}

TEST_F(BrushToolTest, PixelsBecomeALengthWhereTheStrokeBegins) {
  scene_.strips = {{.slope = -0.5f}};
  settings_.radiusUnit = RadiusUnit::kPixels;
  settings_.radiusPx = 30;
  tool_.set(settings_);
  press(kOn);
  const double radius = tool_.stroke().stroke.radius;
  EXPECT_NEAR(radius * static_cast<double>(scene_.view.pixelsPerUnit(scene_.pickAt(kOn)->depth)), 30, 1e-4);
  move({600, 300});
  settings_.radiusPx = 60;
  tool_.set(settings_);
  move({650, 300});
  EXPECT_EQ(tool_.stroke().stroke.radius, radius);
  EXPECT_FLOAT_EQ(tool_.ring()->radius, static_cast<float>(radius));
}

TEST_F(BrushToolTest, PressureScalesWhatItIsMappedTo) {
  const auto pressed = [&](PressureMapping mapping) {
    settings_.pressure = mapping;
    tool_.set(settings_);
    const BrushResponse response = press(kOn, {}, 0.25f);
    release(kOn);
    return std::pair(response.dabs.at(0).pressure, response.dabs.at(0).size);
  };
  EXPECT_EQ(pressed(PressureMapping::kNone), std::pair(1.0, 1.0));
  EXPECT_EQ(pressed(PressureMapping::kStrength), std::pair(0.25, 1.0));
  EXPECT_EQ(pressed(PressureMapping::kSize), std::pair(1.0, 0.25));
}

TEST_F(BrushToolTest, LaysMirrorImagesAfterTheirOriginals) {
  settings_.symmetry = SymmetryAxis::kX;
  settings_.symmetryCenter = kOrigin;
  tool_.set(settings_);
  press(kOn);
  const BrushResponse moved = move({380, 350});
  ASSERT_GT(moved.dabs.size(), 4u);
  ASSERT_EQ(moved.dabs.size() % 2, 0u);
  for (std::size_t d = 0; d < moved.dabs.size(); d += 2) {
    const Eigen::Vector3d &dab = moved.dabs[d].position, &image = moved.dabs[d + 1].position;
    EXPECT_LT(dab.x(), kOrigin.x());
    EXPECT_NEAR(dab.x() + image.x(), 2 * kOrigin.x(), 1e-9);
    EXPECT_EQ(dab.y(), image.y());
    EXPECT_EQ(dab.z(), image.z());
  }
  release(kOn);
  // What lies on the plane is its own image.
  settings_.symmetryCenter.x() += static_cast<double>(scene_.pickAt(kOn)->position.x);
  tool_.set(settings_);
  EXPECT_THAT(press(kOn).dabs, SizeIs(1));
}

TEST_F(BrushToolTest, CancelTakesTheStrokeBack) {
  EXPECT_EQ(tool_.cancel().phase, StrokePhase::kNone);
  press(kOn);
  EXPECT_EQ(tool_.cancel().phase, StrokePhase::kCancelled);
  EXPECT_FALSE(tool_.isStroking());
  EXPECT_EQ(release(kOn).phase, StrokePhase::kNone);
}

TEST_F(BrushToolTest, TheRingFollowsTheSurface) {
  EXPECT_FALSE(move(kBeside).redraw);
  EXPECT_FALSE(tool_.ring());
  EXPECT_TRUE(move(kOn).redraw);
  ASSERT_TRUE(tool_.ring());
  EXPECT_EQ(tool_.ring()->center, scene_.pickAt(kOn)->position);
  EXPECT_FLOAT_EQ(tool_.ring()->radius, 0.2f);
  EXPECT_TRUE(move(kBeside).redraw);
  EXPECT_FALSE(tool_.ring());
  move(kOn);
  EXPECT_TRUE(send({.action = PointerAction::kLeave}).redraw);
  EXPECT_FALSE(tool_.ring());
}

TEST_F(BrushToolTest, StepsAndAltWheelChangeTheSize) {
  tool_.stepSize(1, canvas());
  EXPECT_NEAR(tool_.settings().radius, 0.22, 1e-6);
  tool_.stepSize(-1, canvas());
  EXPECT_NEAR(tool_.settings().radius, 0.2, 1e-6);
  const BrushResponse response =
      send({.action = PointerAction::kWheel, .px = kOn, .modifiers = {.alt = true}, .wheelSteps = 2});
  EXPECT_TRUE(response.taken);
  EXPECT_NEAR(tool_.settings().radius, 0.2 * 1.21, 1e-6);
  tool_.stepSize(-1e6f, canvas());
  EXPECT_GT(tool_.settings().radius, 0);
  settings_.radiusUnit = RadiusUnit::kPixels;
  tool_.set(settings_);
  tool_.stepSize(1e6f, canvas());
  EXPECT_LE(tool_.settings().radiusPx, 2000);
}

TEST_F(BrushToolTest, DragsAdjustTheRadiusAndTheStrength) {
  settings_.strength = 0.5;
  tool_.set(settings_);
  move(kOn);
  tool_.beginAdjusting(BrushAdjustment::kRadius, kOn, canvas());
  EXPECT_EQ(tool_.adjusting(), BrushAdjustment::kRadius);
  EXPECT_TRUE(move(kOn + glm::vec2(50, 0)).taken);
  const double grown = 0.2 + 50 * static_cast<double>(scene_.pixel());
  EXPECT_NEAR(tool_.settings().radius, grown, 1e-5);
  EXPECT_NEAR(tool_.ring()->radius, grown, 1e-5);
  EXPECT_TRUE(press(kOn + glm::vec2(50, 0)).taken) << "the click that confirms paints nothing";
  EXPECT_TRUE(release(kOn + glm::vec2(50, 0)).taken);
  EXPECT_EQ(tool_.adjusting(), BrushAdjustment::kNone);
  EXPECT_FALSE(tool_.isStroking());

  tool_.beginAdjusting(BrushAdjustment::kStrength, kOn, canvas());
  move(kOn + glm::vec2(60, 0));
  EXPECT_NEAR(tool_.settings().strength, 0.7, 1e-6);
  move(kOn - glm::vec2(4000, 0));
  EXPECT_GT(tool_.settings().strength, 0);
  tool_.cancel();
  EXPECT_EQ(tool_.settings().strength, 0.5);
  EXPECT_EQ(tool_.adjusting(), BrushAdjustment::kNone);
  EXPECT_NEAR(tool_.settings().radius, grown, 1e-5);
}

}  // namespace
}  // namespace stipple
