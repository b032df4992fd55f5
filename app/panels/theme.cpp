#include "app/panels/theme.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "app/panels/fonts.h"

namespace stipple {

namespace {

// Inter: height of its line and of a small x, in units of the em (2816).
constexpr float kLinePerEm = (2728 + 680) / 2816.0f;
constexpr float kXHeightPerEm = 1536 / 2816.0f;

// Order of the fonts in the atlas.
enum FontIndex { kBody, kSmall, kTitle };

// Latin, Greek, and the signs of formulas and shortcuts that the font files hold.
constexpr ImWchar kGlyphs[] = {0x20,   0x7E,   0xA0,   0x17F,  0x391,  0x3C9,  0x2013, 0x2026, 0x2032,
                               0x2032, 0x2070, 0x2089, 0x2190, 0x2193, 0x2212, 0x2212, 0x221E, 0x221E,
                               0x2248, 0x2248, 0x2260, 0x2265, 0x21E7, 0x21E7, 0};

// Letters are as high as whole pixels, so that their upper and lower edges are sharp.
float lineHeightFor(float xHeight) {
  return std::max(std::round(xHeight), 1.0f) / kXHeightPerEm * kLinePerEm;
}

void addFont(ImFontAtlas& atlas, std::span<const unsigned char> file, float xHeight) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  // One texel is one pixel.
  config.OversampleH = config.OversampleV = 1;
  config.PixelSnapH = true;
  // The atlas does not write to what it does not own.
  void* bytes = const_cast<unsigned char*>(file.data());
  atlas.AddFontFromMemoryTTF(bytes, static_cast<int>(file.size()), lineHeightFor(xHeight), &config, kGlyphs);
}

ImVec4 gray(float value, float alpha = 1) {
  return {value, value, value, alpha};
}

const ImVec4 kAccent{1.0f, 152 / 255.0f, 26 / 255.0f, 1.0f};  // also the color of selected points

// Grays of the two themes, from the ground of a panel to its text.
struct Grays {
  float panel, popup, field, fieldHovered, fieldActive, button, buttonHovered, buttonActive, text, dimText;
  float line;  // black or white
  float lineAlpha;
  float panelAlpha;
  ImVec4 accentInk;  // for lines and letters
};
const Grays kDark{.panel = 0.118f,
                  .popup = 0.137f,
                  .field = 0.20f,
                  .fieldHovered = 0.235f,
                  .fieldActive = 0.255f,
                  .button = 0.235f,
                  .buttonHovered = 0.29f,
                  .buttonActive = 0.345f,
                  .text = 0.90f,
                  .dimText = 0.62f,
                  .line = 1,
                  .lineAlpha = 0.09f,
                  .panelAlpha = 0.93f,
                  .accentInk = kAccent};
const Grays kLight{.panel = 0.965f,
                   .popup = 0.98f,
                   .field = 0.90f,
                   .fieldHovered = 0.87f,
                   .fieldActive = 0.85f,
                   .button = 0.885f,
                   .buttonHovered = 0.84f,
                   .buttonActive = 0.79f,
                   .text = 0.11f,
                   .dimText = 0.40f,
                   .line = 0,
                   .lineAlpha = 0.13f,
                   .panelAlpha = 0.95f,
                   .accentInk = {0.70f, 0.37f, 0.0f, 1}};

void setColors(ImVec4* colors, const Grays& grays) {
  std::fill_n(colors, int(ImGuiCol_COUNT), gray(0, 0));
  colors[ImGuiCol_Text] = gray(grays.text);
  colors[ImGuiCol_TextDisabled] = gray(grays.dimText);
  colors[ImGuiCol_WindowBg] = gray(grays.panel, grays.panelAlpha);
  colors[ImGuiCol_PopupBg] = gray(grays.popup);
  colors[ImGuiCol_Border] = colors[ImGuiCol_Separator] = gray(grays.line, grays.lineAlpha);
  colors[ImGuiCol_FrameBg] = gray(grays.field);
  colors[ImGuiCol_FrameBgHovered] = gray(grays.fieldHovered);
  colors[ImGuiCol_FrameBgActive] = gray(grays.fieldActive);
  colors[ImGuiCol_Button] = colors[ImGuiCol_Header] = gray(grays.button);
  colors[ImGuiCol_ButtonHovered] = colors[ImGuiCol_HeaderHovered] = gray(grays.buttonHovered);
  colors[ImGuiCol_ButtonActive] = colors[ImGuiCol_HeaderActive] = gray(grays.buttonActive);
  // The part of a field that its value fills.
  colors[ImGuiCol_SliderGrab] = gray(grays.line, 0.13f);
  colors[ImGuiCol_SliderGrabActive] = gray(grays.line, 0.18f);
  colors[ImGuiCol_ScrollbarGrab] = gray(grays.line, 0.2f);
  colors[ImGuiCol_ScrollbarGrabHovered] = gray(grays.line, 0.3f);
  colors[ImGuiCol_ScrollbarGrabActive] = gray(grays.line, 0.4f);
  colors[ImGuiCol_PlotHistogram] = kAccent;
  colors[ImGuiCol_CheckMark] = colors[ImGuiCol_PlotLines] = grays.accentInk;
  colors[ImGuiCol_TextSelectedBg] = {kAccent.x, kAccent.y, kAccent.z, 0.35f};
}

}  // namespace

void applyStyle(const OverlayLook& look) {
  ImGuiStyle style;
  style.WindowPadding = ImVec2(12, 10);
  style.FramePadding = ImVec2(8, 4);
  style.ItemSpacing = ImVec2(6, 6);
  style.ItemInnerSpacing = ImVec2(6, 4);
  style.WindowRounding = style.PopupRounding = 8;
  style.FrameRounding = style.GrabRounding = 4;
  style.ScrollbarSize = 8;
  style.ScrollbarRounding = 4;
  style.WindowMinSize = ImVec2(16, 16);
  style.ScaleAllSizes(look.scale);
  style.WindowBorderSize = style.PopupBorderSize = std::max(1.0f, std::round(look.scale));
  style.MouseCursorScale = look.scale;
  // Lines as triangles with soft edges: sharper than those of the atlas at broken scales.
  style.AntiAliasedLinesUseTex = false;
  style.CircleTessellationMaxError = 0.2f;
  setColors(style.Colors, look.theme == OverlayTheme::kDark ? kDark : kLight);
  ImGui::GetStyle() = style;
}

void buildFonts(ImFontAtlas& atlas, float scale) {
  atlas.Clear();
  atlas.Flags |= ImFontAtlasFlags_NoMouseCursors | ImFontAtlasFlags_NoBakedLines;
  addFont(atlas, interRegular(), 7 * scale);
  addFont(atlas, interRegular(), 6 * scale);
  addFont(atlas, interSemiBold(), 7 * scale);
  atlas.Build();
  // Lines of whole pixels keep everything that is stacked on pixels; glyphs are placed by their baseline.
  for (ImFont* font : atlas.Fonts) font->FontSize = std::round(font->FontSize);
}

ImFont* bodyFont() {
  return ImGui::GetIO().Fonts->Fonts[kBody];
}

ImFont* smallFont() {
  return ImGui::GetIO().Fonts->Fonts[kSmall];
}

ImFont* titleFont() {
  return ImGui::GetIO().Fonts->Fonts[kTitle];
}

float overlayScale() {
  return ImGui::GetStyle().MouseCursorScale;
}

float scaled(float length) {
  return std::round(length * overlayScale());
}

}  // namespace stipple
