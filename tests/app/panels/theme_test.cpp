#include "app/panels/theme.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <cmath>

#include "tests/app/panels/overlay_picture.h"

namespace stipple {
namespace {

TEST(Theme, DoesNotTintColors) {
  for (const OverlayTheme theme : {OverlayTheme::kDark, OverlayTheme::kLight}) {
    OverlayContext context({.theme = theme});
    context.makeCurrent();
    for (const ImGuiCol color : {ImGuiCol_Text, ImGuiCol_WindowBg, ImGuiCol_FrameBg, ImGuiCol_Button}) {
      const ImVec4& value = ImGui::GetStyle().Colors[color];
      EXPECT_TRUE(value.x == value.y && value.y == value.z) << ImGui::GetStyleColorName(color);
    }
  }
}

// Relative luminance of an sRGB gray (WCAG 2).
double luminance(double gray) {
  return gray <= 0.04045 ? gray / 12.92 : std::pow((gray + 0.055) / 1.055, 2.4);
}

TEST(Theme, TextStandsOutFromItsGround) {
  for (const OverlayTheme theme : {OverlayTheme::kDark, OverlayTheme::kLight}) {
    OverlayContext context({.theme = theme});
    context.makeCurrent();
    const ImVec4* colors = ImGui::GetStyle().Colors;
    const double ground = luminance(colors[ImGuiCol_WindowBg].x) + 0.05;
    for (const ImGuiCol text : {ImGuiCol_Text, ImGuiCol_TextDisabled}) {
      const double front = luminance(colors[text].x) + 0.05;
      EXPECT_GT(std::max(front, ground) / std::min(front, ground), 4.5) << ImGui::GetStyleColorName(text);
    }
  }
}

TEST(Theme, FontsHoldTheSignsInUse) {
  for (const float scale : {1.0f, 1.5f, 2.0f}) {
    OverlayContext context({.scale = scale});
    context.makeCurrent();
    for (ImFont* font : {bodyFont(), smallFont(), titleFont()}) {
      for (const ImWchar sign :
           {u'A', u'\u00e9', u'\u00b0', u'\u00d7', u'\u00b2', u'\u03c4', u'\u2026', u'\u2212'}) {
        EXPECT_NE(font->FindGlyphNoFallback(sign), nullptr) << int(sign);
      }
      // Digits are equally wide: numbers that change do not wobble.
      for (ImWchar digit = '0'; digit <= '9'; ++digit) {
        EXPECT_EQ(font->GetCharAdvance(digit), font->GetCharAdvance('0'));
      }
    }
    EXPECT_LT(smallFont()->FontSize, bodyFont()->FontSize);
    EXPECT_EQ(overlayScale(), scale);
  }
}

TEST(Theme, ReadsWell) {
  for (const auto& [scale, name] : {std::pair(1.0f, "1"), {1.5f, "1.5"}, {2.0f, "2"}}) {
    for (const OverlayTheme theme : {OverlayTheme::kDark, OverlayTheme::kLight}) {
      OverlayStage stage(int(420 * scale), int(210 * scale), {.scale = scale, .theme = theme});
      stage.settle([&] {
        ImGui::SetNextWindowPos(ImVec2(20 * scale, 20 * scale));
        ImGui::Begin("text", nullptr, ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_AlwaysAutoResize);
        ImGui::PushFont(titleFont());
        ImGui::TextUnformatted("Reaction and diffusion");
        ImGui::PopFont();
        ImGui::TextUnformatted("Splats 1,234,567   frame 8.90 ms   \u03c4 3.0 px");
        ImGui::TextUnformatted("The quick brown fox jumps over the lazy dog");
        ImGui::PushFont(smallFont());
        ImGui::TextDisabled("Smaller and dimmer: 0.0125 model units, 56\u00b0, 3 \u00d7 10\u207b\u2074");
        ImGui::PopFont();
        ImGui::Button("Pause");
        ImGui::End();
      });
      stage.save(std::string(theme == OverlayTheme::kDark ? "text_dark_" : "text_light_") + name);
    }
  }
}

}  // namespace
}  // namespace stipple
