#include "app/panels/overlay_context.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cfloat>
#include <utility>

namespace stipple {

namespace {

struct ContextDeleter {
  void operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }
};

// Down now, or went down since the last frame.
struct Switch {
  bool isDown = false, wentDown = false;

  void set(bool down) {
    wentDown |= down && !isDown;
    isDown = down;
  }
  bool read() { return std::exchange(wentDown, false) || isDown; }
  // A press was shown to the last frame whose release was not.
  bool isBehind(bool shown) const { return wentDown || shown != isDown; }
};

void mapKeys(ImGuiIO& io) {
  constexpr std::pair<ImGuiKey_, OverlayKey> kKeys[] = {
      {ImGuiKey_Tab, OverlayKey::kTab},
      {ImGuiKey_LeftArrow, OverlayKey::kLeft},
      {ImGuiKey_RightArrow, OverlayKey::kRight},
      {ImGuiKey_UpArrow, OverlayKey::kUp},
      {ImGuiKey_DownArrow, OverlayKey::kDown},
      {ImGuiKey_PageUp, OverlayKey::kPageUp},
      {ImGuiKey_PageDown, OverlayKey::kPageDown},
      {ImGuiKey_Home, OverlayKey::kHome},
      {ImGuiKey_End, OverlayKey::kEnd},
      {ImGuiKey_Insert, OverlayKey::kInsert},
      {ImGuiKey_Delete, OverlayKey::kDelete},
      {ImGuiKey_Backspace, OverlayKey::kBackspace},
      {ImGuiKey_Space, OverlayKey::kSpace},
      {ImGuiKey_Enter, OverlayKey::kEnter},
      {ImGuiKey_Escape, OverlayKey::kEscape},
      {ImGuiKey_A, OverlayKey::kA},
      {ImGuiKey_C, OverlayKey::kC},
      {ImGuiKey_V, OverlayKey::kV},
      {ImGuiKey_X, OverlayKey::kX},
      {ImGuiKey_Y, OverlayKey::kY},
      {ImGuiKey_Z, OverlayKey::kZ},
  };
  for (const auto& [theirs, ours] : kKeys) io.KeyMap[theirs] = static_cast<int>(ours);
}

bool isPanelAt(const ImGuiContext& context, glm::vec2 position) {
  return std::ranges::any_of(context.Windows, [&](const ImGuiWindow* window) {
    return window->WasActive && !window->Hidden && !(window->Flags & ImGuiWindowFlags_NoMouseInputs) &&
           window->OuterRectClipped.Contains(ImVec2(position.x, position.y));
  });
}

constexpr glm::vec2 kNowhere{-FLT_MAX, -FLT_MAX};

}  // namespace

struct OverlayContext::State {
  std::unique_ptr<ImGuiContext, ContextDeleter> context{ImGui::CreateContext()};
  OverlayLook look;
  std::uint64_t atlasRevision = 0;
  glm::vec2 mouse = kNowhere;
  std::array<Switch, 3> buttons;
  std::array<Switch, kOverlayKeys> keys;
  bool ownsDrag = false;
  bool hasNews = false;  // moves, wheel, characters

  bool isDragging() const { return std::ranges::any_of(buttons, &Switch::isDown); }
};

OverlayContext::OverlayContext(const OverlayLook& look) : state_(std::make_unique<State>()) {
  makeCurrent();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
  io.ConfigWindowsMoveFromTitleBarOnly = true;
  mapKeys(io);
  setLook(look);
}

OverlayContext::~OverlayContext() = default;
OverlayContext::OverlayContext(OverlayContext&&) noexcept = default;
OverlayContext& OverlayContext::operator=(OverlayContext&&) noexcept = default;

void OverlayContext::makeCurrent() const {
  ImGui::SetCurrentContext(state_->context.get());
}

const OverlayLook& OverlayContext::look() const {
  return state_->look;
}

void OverlayContext::setLook(const OverlayLook& look) {
  makeCurrent();
  if (state_->atlasRevision == 0 || look.scale != state_->look.scale) {
    buildFonts(*ImGui::GetIO().Fonts, look.scale);
    ++state_->atlasRevision;
  }
  state_->look = look;
  applyStyle(look);
}

void OverlayContext::moveMouse(glm::vec2 position) {
  state_->hasNews |= position != state_->mouse;
  state_->mouse = position;
}

void OverlayContext::leaveMouse() {
  moveMouse(kNowhere);
}

void OverlayContext::setButton(OverlayButton button, bool isDown) {
  if (isDown && !state_->isDragging()) state_->ownsDrag = wantsMouse();
  state_->buttons[static_cast<int>(button)].set(isDown);
}

void OverlayContext::turnWheel(float notches) {
  state_->context->IO.MouseWheel += notches;
  state_->hasNews = true;
}

void OverlayContext::setModifiers(const OverlayModifiers& modifiers) {
  ImGuiIO& io = state_->context->IO;
  io.KeyCtrl = modifiers.ctrl;
  io.KeyShift = modifiers.shift;
  io.KeyAlt = modifiers.alt;
}

void OverlayContext::setKey(OverlayKey key, bool isDown) {
  state_->keys[static_cast<int>(key)].set(isDown);
}

void OverlayContext::typeCharacter(char32_t character) {
  makeCurrent();
  state_->context->IO.AddInputCharacter(character);
  state_->hasNews = true;
}

bool OverlayContext::hasPendingInput() const {
  const ImGuiIO& io = state_->context->IO;
  bool isBehind = state_->hasNews;
  for (std::size_t i = 0; i < state_->buttons.size(); ++i) {
    isBehind |= state_->buttons[i].isBehind(io.MouseDown[i]);
  }
  for (std::size_t i = 0; i < state_->keys.size(); ++i) isBehind |= state_->keys[i].isBehind(io.KeysDown[i]);
  return isBehind;
}

bool OverlayContext::hasHiddenPanels() const {
  return std::ranges::any_of(state_->context->Windows, [](const ImGuiWindow* window) {
    return window->Active &&
           (window->HiddenFramesCanSkipItems > 0 || window->HiddenFramesCannotSkipItems > 0);
  });
}

void OverlayContext::beginFrame(glm::ivec2 size, float seconds) {
  makeCurrent();
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = ImVec2(float(size.x), float(size.y));
  io.DisplayFramebufferScale = ImVec2(1, 1);
  // Dear ImGui asks for time that passes.
  constexpr float kLeastSeconds = 1e-4f;
  io.DeltaTime = std::max(seconds, kLeastSeconds);
  io.MousePos = ImVec2(state_->mouse.x, state_->mouse.y);
  for (std::size_t i = 0; i < state_->buttons.size(); ++i) io.MouseDown[i] = state_->buttons[i].read();
  for (std::size_t i = 0; i < state_->keys.size(); ++i) io.KeysDown[i] = state_->keys[i].read();
  state_->hasNews = false;
  ImGui::NewFrame();
}

const ImDrawData& OverlayContext::endFrame() {
  makeCurrent();
  ImGui::Render();
  return *ImGui::GetDrawData();
}

bool OverlayContext::wantsMouse() const {
  if (state_->isDragging()) return state_->ownsDrag;
  // A click beside an open popup closes it and does nothing else.
  return state_->context->OpenPopupStack.Size > 0 || isPanelAt(*state_->context, state_->mouse);
}

bool OverlayContext::wantsKeyboard() const {
  return state_->context->IO.WantTextInput || state_->context->OpenPopupStack.Size > 0;
}

OverlayCursor OverlayContext::cursor() const {
  switch (state_->context->MouseCursor) {
    case ImGuiMouseCursor_TextInput:
      return OverlayCursor::kText;
    case ImGuiMouseCursor_Hand:
      return OverlayCursor::kHand;
    case ImGuiMouseCursor_ResizeEW:
      return OverlayCursor::kDragSideways;
    default:
      return OverlayCursor::kArrow;
  }
}

AlphaTexture OverlayContext::atlas() const {
  unsigned char* texels = nullptr;
  AlphaTexture atlas;
  state_->context->IO.Fonts->GetTexDataAsAlpha8(&texels, &atlas.width, &atlas.height);
  atlas.texels = {texels, static_cast<std::size_t>(atlas.width) * atlas.height};
  return atlas;
}

std::uint64_t OverlayContext::atlasRevision() const {
  return state_->atlasRevision;
}

}  // namespace stipple
