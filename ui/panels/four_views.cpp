#include "ui/model/four_views.h"

#include <string>
#include <vector>

#include "sim/scene/quantities.h"
#include "ui/panels/overlays.h"
#include "ui/panels/view_drawing.h"
#include "ui/widgets/style.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr char kAsCamera[] = "As in View";

void side_row(Panel& panel, const std::string& tag, ViewSide& side) {
  const std::vector<std::string> names(kViewSideNames.begin() + 1, kViewSideNames.end());
  const std::string shown = kViewSideNames[static_cast<std::size_t>(side)];
  const int chosen = combo_row(panel, (tag + "/side").c_str(), "Side", names, shown);
  if (chosen >= 0) side = static_cast<ViewSide>(chosen + 1);
}

void quantity_row(Panel& panel, const std::string& tag, std::string& quantity) {
  const std::vector<const Quantity*> quantities = view_quantities();
  std::vector<std::string> labels = {kAsCamera};
  for (const Quantity* offered : quantities) labels.emplace_back(offered->label);
  const Quantity* current = find_view_quantity(quantity);
  const std::string shown(quantity.empty() || !current ? kAsCamera : current->label);
  const int chosen = combo_row(panel, (tag + "/quantity").c_str(), "Color by", labels, shown);
  if (chosen >= 0) quantity = chosen == 0 ? "" : quantities[static_cast<std::size_t>(chosen) - 1]->key;
}

/// Draws the name of the view in its upper right corner: a button for its settings, if it has any.
void draw_name(Panel& panel) {
  const auto view = static_cast<std::size_t>(panel.view);
  FourViews& views = panel.state.four_views;
  const std::string name = kViewSideNames[static_cast<std::size_t>(views.sides[view])];
  const std::string tag = "views/" + std::to_string(view);
  const float margin = 8 * ui_scale(panel), padding = ImGui::GetStyle().FramePadding.x;
  const ScreenArea area = view_area(panel);
  const float width = ImGui::CalcTextSize(name.c_str()).x + 2 * padding;
  ImGui::SetCursorScreenPos({area.maximum.x - margin - width, area.minimum.y + margin});
  const std::string popup = "##" + tag;
  if (ImGui::Button((name + "###" + tag).c_str()) && view > 0) ImGui::OpenPopup(popup.c_str());
  tag_last_item(panel.tags, tag, name);
  tooltip(view > 0 ? "Choose the side from which this view looks, and what it shows."
                   : "The view by your camera. The others look at the same place.");
  if (!ImGui::BeginPopup(popup.c_str())) return;
  ImGui::Dummy({260 * ui_scale(panel), 0});
  side_row(panel, tag, views.sides[view]);
  quantity_row(panel, tag, views.quantities[view]);
  ImGui::EndPopup();
}

}  // namespace

void draw_view_names(Panel& panel) {
  const FourViews& views = panel.state.four_views;
  if (!views.shown) return;
  ImDrawList* list = ImGui::GetWindowDrawList();
  for (panel.view = 0; panel.view < views.count(); ++panel.view) {
    const ScreenArea area = view_area(panel);
    list->AddRect(area.minimum, area.maximum, is_active_view(panel) ? palette::kAccentDim : palette::kWindow, 0,
                  ImDrawFlags_None, 2 * ui_scale(panel));
    draw_name(panel);
  }
  panel.view = 0;
}

}  // namespace griffith::ui
