#include "app/panels/panel_window.h"

#include <imgui.h>

#include "app/panels/theme.h"

namespace stipple {

PanelWindow::PanelWindow(const char* name, const PanelPlace& place, const PanelOptions& options) {
  const glm::vec2 anchor = place.position + place.align * place.size;
  ImGui::SetNextWindowPos(ImVec2(anchor.x, anchor.y), ImGuiCond_Always, ImVec2(place.align.x, place.align.y));
  ImGui::SetNextWindowSizeConstraints(ImVec2(options.fillsWidth ? place.size.x : 0, 0),
                                      ImVec2(place.size.x, place.size.y));
  ImGui::PushStyleVar(ImGuiStyleVar_Alpha, options.opacity);
  ImGui::Begin(name, nullptr,
               ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                   ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings |
                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus |
                   ImGuiWindowFlags_NoNav);
}

PanelWindow::~PanelWindow() {
  ImGui::End();
  ImGui::PopStyleVar();
}

}  // namespace stipple
