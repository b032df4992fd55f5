#include "app/panels/overlay_layout.h"

#include <algorithm>
#include <cmath>

namespace stipple {

namespace {

// In pixels of a plain screen. The heights hold what the panels ask for at most.
constexpr float kMargin = 12, kGap = 10;
constexpr float kLeftWidth = 244, kRightWidth = 196, kLegendWidth = 140;
constexpr float kCurveHeight = 224, kStatisticsHeight = 172;
constexpr float kMessageHeight = 46;
constexpr float kCardWidth = 224, kCardHeight = 112;

// Places in pixels of a plain screen, later multiplied by the scale.
class Columns {
 public:
  Columns(glm::vec2 view, const OverlayContent& content)
      : view_(view),
        middleLeft_(content.brush || content.curve ? kMargin + kLeftWidth + kGap : kMargin),
        middleRight_(view.x -
                     (content.statistics || content.legend ? kMargin + kRightWidth + kGap : kMargin)) {}

  float height() const { return std::max(view_.y - 2 * kMargin, 0.0f); }
  float middleWidth() const { return std::max(middleRight_ - middleLeft_, 0.0f); }

  PanelPlace left(float top, float height, float align) const {
    return {{kMargin, kMargin + top}, {kLeftWidth, std::max(height, 0.0f)}, {0, align}};
  }
  PanelPlace statistics(float height) const {
    return {{view_.x - kMargin - kRightWidth, kMargin}, {kRightWidth, height}, {1, 0}};
  }
  PanelPlace legend(float top, float height) const {
    return {
        {view_.x - kMargin - kLegendWidth, kMargin + top}, {kLegendWidth, std::max(height, 0.0f)}, {1, 1}};
  }
  PanelPlace message() const {
    return {{middleLeft_, view_.y - kMargin - kMessageHeight}, {middleWidth(), kMessageHeight}, {0.5f, 1}};
  }

  // Rows of cards, the last one above `bottom`, each row centered.
  std::vector<PanelPlace> cards(std::size_t count, float bottom) const {
    const auto fitting = [](float room, float size) {
      return std::max(int((room + kGap) / (size + kGap)), 0);
    };
    const int columns = std::min(fitting(middleWidth(), kCardWidth), int(count));
    const int rows =
        columns > 0 ? std::min(fitting(bottom - kMargin, kCardHeight), (int(count) + columns - 1) / columns)
                    : 0;
    std::vector<PanelPlace> places;
    for (int row = 0; row < rows; ++row) {
      const int inRow = std::min(columns, int(count) - row * columns);
      const float width = float(inRow) * (kCardWidth + kGap) - kGap;
      const float y = bottom - float(rows - row) * (kCardHeight + kGap) + kGap;
      for (int column = 0; column < inRow; ++column) {
        const float x = middleLeft_ + (middleWidth() - width) / 2 + float(column) * (kCardWidth + kGap);
        places.push_back({{x, y}, {kCardWidth, kCardHeight}, {}});
      }
    }
    return places;
  }

 private:
  glm::vec2 view_;
  float middleLeft_, middleRight_;
};

void toDevicePixels(PanelPlace& place, float scale) {
  place.position = glm::vec2(std::round(place.position.x * scale), std::round(place.position.y * scale));
  place.size = glm::vec2(std::floor(place.size.x * scale), std::floor(place.size.y * scale));
}

}  // namespace

OverlayLayout layOut(glm::vec2 view, float scale, const OverlayContent& content) {
  view /= scale;
  const Columns columns(view, content);
  const float height = columns.height();
  const float curve = content.curve ? std::min(kCurveHeight, height) : 0;
  const float statistics = content.statistics ? std::min(kStatisticsHeight, height) : 0;
  const float aboveCurve = height - (content.curve ? curve + kGap : 0);
  const float belowStatistics = content.statistics ? statistics + kGap : 0;
  OverlayLayout layout{.brush = columns.left(0, aboveCurve, 0),
                       .curve = columns.left(height - curve, curve, 1),
                       .statistics = columns.statistics(statistics),
                       .legend = columns.legend(belowStatistics, height - belowStatistics),
                       .message = columns.message(),
                       .cards = {}};
  const float bottom = view.y - kMargin - (content.message ? kMessageHeight + kGap : 0);
  layout.cards = columns.cards(content.cards, bottom);
  for (PanelPlace* place :
       {&layout.brush, &layout.curve, &layout.statistics, &layout.legend, &layout.message}) {
    toDevicePixels(*place, scale);
  }
  for (PanelPlace& place : layout.cards) toDevicePixels(place, scale);
  return layout;
}

}  // namespace stipple
