#include "app/panels/icons.h"

#include <algorithm>
#include <initializer_list>

namespace stipple {

namespace {

// A pen on a sheet of 16 x 16 units.
class Pen {
 public:
  Pen(ImDrawList& list, ImVec2 center, float size, ImU32 color)
      : list_(list), unit_(size / 16), origin_(center.x - size / 2, center.y - size / 2), color_(color) {}

  ImVec2 at(ImVec2 p) const { return {origin_.x + p.x * unit_, origin_.y + p.y * unit_}; }

  void line(std::initializer_list<ImVec2> points, bool closed = false, float weight = kWeight) {
    for (const ImVec2& point : points) list_.PathLineTo(at(point));
    list_.PathStroke(color_, closed ? ImDrawFlags_Closed : 0, std::max(weight * unit_, 1.0f));
  }
  void curve(ImVec2 a, ImVec2 b, ImVec2 c, ImVec2 d) {
    list_.PathLineTo(at(a));
    list_.PathBezierCubicCurveTo(at(b), at(c), at(d));
    list_.PathStroke(color_, 0, std::max(kWeight * unit_, 1.0f));
  }
  void fill(std::initializer_list<ImVec2> points) {
    for (const ImVec2& point : points) list_.PathLineTo(at(point));
    list_.PathFillConvex(color_);
  }
  void box(ImVec2 from, ImVec2 to, float rounding) {
    list_.AddRectFilled(at(from), at(to), color_, rounding * unit_);
  }
  void frame(ImVec2 from, ImVec2 to, float rounding) {
    list_.AddRect(at(from), at(to), color_, rounding * unit_, 0, std::max(kWeight * unit_, 1.0f));
  }
  void dot(ImVec2 center, float radius) { list_.AddCircleFilled(at(center), radius * unit_, color_); }
  void ring(ImVec2 center, float radius) {
    list_.AddCircle(at(center), radius * unit_, color_, 0, std::max(kWeight * unit_, 1.0f));
  }

 private:
  static constexpr float kWeight = 1.5f;
  ImDrawList& list_;
  float unit_;
  ImVec2 origin_;
  ImU32 color_;
};

void drawBrush(Pen& pen) {
  // The handle, its ferrule, and the tip bent by its stroke.
  pen.line({{13.6f, 2.4f}, {7.6f, 8.4f}}, false, 2.4f);
  pen.curve({7.4f, 8.2f}, {4.6f, 7.6f}, {3.4f, 10.2f}, {3.6f, 11.6f});
  pen.curve({3.6f, 11.6f}, {3.5f, 12.6f}, {2.9f, 13.1f}, {2.0f, 13.3f});
  pen.curve({2.0f, 13.3f}, {4.6f, 14.6f}, {8.4f, 13.4f}, {7.9f, 8.8f});
}

void drawEraser(Pen& pen) {
  pen.line({{9.3f, 2.6f}, {13.6f, 6.9f}, {7.6f, 12.9f}, {5.0f, 12.9f}, {2.2f, 10.1f}, {2.2f, 9.7f}}, true);
  pen.line({{5.9f, 6.2f}, {10.0f, 10.3f}});
  pen.line({{7.6f, 12.9f}, {14.0f, 12.9f}});
}

void drawWaves(Pen& pen) {
  pen.curve({1.6f, 6.2f}, {3.9f, -0.6f}, {5.7f, -0.6f}, {8.0f, 5.0f});
  pen.curve({8.0f, 5.0f}, {10.0f, 9.2f}, {12.2f, 9.0f}, {14.4f, 4.4f});
  pen.curve({1.6f, 12.4f}, {5.4f, 9.8f}, {10.6f, 14.2f}, {14.4f, 11.6f});
}

void drawDashedFrame(Pen& pen) {
  constexpr float kLow = 2.5f, kHigh = 13.5f, kArm = 2.6f;
  for (const float x : {kLow, kHigh}) {
    for (const float y : {kLow, kHigh}) {
      const float inX = x == kLow ? kArm : -kArm, inY = y == kLow ? kArm : -kArm;
      pen.line({{x + inX, y}, {x, y}, {x, y + inY}});
    }
  }
  for (const float side : {kLow, kHigh}) {
    pen.line({{6.8f, side}, {9.2f, side}});
    pen.line({{side, 6.8f}, {side, 9.2f}});
  }
}

}  // namespace

void drawIcon(ImDrawList& list, Icon icon, ImVec2 center, float size, ImU32 color) {
  Pen pen(list, center, size, color);
  switch (icon) {
    case Icon::kPaint:
      return drawBrush(pen);
    case Icon::kErase:
      return drawEraser(pen);
    case Icon::kSmooth:
      return drawWaves(pen);
    case Icon::kSelect:
      return drawDashedFrame(pen);
    case Icon::kPlay:
      return pen.fill({{4.5f, 2.8f}, {13.2f, 8}, {4.5f, 13.2f}});
    case Icon::kPause:
      pen.box({4, 3}, {7, 13}, 0.8f);
      return pen.box({9, 3}, {12, 13}, 0.8f);
    case Icon::kStep:
      pen.fill({{3.5f, 3}, {10.2f, 8}, {3.5f, 13}});
      return pen.box({11, 3}, {13, 13}, 0.6f);
    case Icon::kStop:
      return pen.box({3.5f, 3.5f}, {12.5f, 12.5f}, 1.2f);
    case Icon::kClose:
      pen.line({{4, 4}, {12, 12}});
      return pen.line({{12, 4}, {4, 12}});
    case Icon::kAdd:
      pen.line({{8, 3}, {8, 13}});
      return pen.line({{3, 8}, {13, 8}});
    case Icon::kChevron:
      return pen.line({{4, 6}, {8, 10.2f}, {12, 6}});
    case Icon::kWarning:
      pen.line({{8, 2.4f}, {14.2f, 13.2f}, {1.8f, 13.2f}}, true);
      pen.line({{8, 6.4f}, {8, 9.6f}});
      return pen.dot({8, 11.4f}, 0.95f);
    case Icon::kNote:
      pen.ring({8, 8}, 6);
      pen.line({{8, 7.4f}, {8, 11.2f}});
      return pen.dot({8, 5.1f}, 0.95f);
  }
}

}  // namespace stipple
