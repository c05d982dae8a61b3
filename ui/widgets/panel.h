#pragma once

#include <imgui.h>

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "sim/world/output/frame.h"
#include "ui/model/aim.h"
#include "ui/model/editor_state.h"
#include "ui/model/region_outline.h"
#include "ui/model/view_camera.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/labels.h"
#include "ui/widgets/legend.h"
#include "ui/widgets/widget_tags.h"

namespace griffith::ui {

/// One of the views of the scene.
struct ShownView {
  ImTextureID picture = nullptr;     ///< bottom row first; null before it is drawn
  ViewCamera camera;                 ///< camera of the picture
  std::optional<Legend> legend;      ///< legend of the picture
  std::vector<PictureLabel> labels;  ///< labels of the picture
};

/// Input of the panels, new for every drawn frame.
struct EditorInput {
  std::span<const CommandInfo> commands;  ///< all commands, in the order of menus and help
  Frame frame;
  Fonts fonts;
  std::array<ShownView, kMaxViews> views;               ///< the first one, or four
  std::vector<RegionLine> symbol_lines;                 ///< outline of the picked symbol, in the picture's world
  BodyId pointed;                                       ///< piece at EditorState::pointed_at; invalid: none
  Aim aim;                                              ///< predicted flight of the aimed shot
  std::span<const UtilizationSample> utilizations;      ///< past of the selected node, oldest first
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();         ///< bounding box of the bodies [m]
  Vec3 toward_eye = Vec3::UnitZ();                      ///< direction from the target of the user's camera
  std::span<const std::filesystem::path> scene_files;   ///< scenes that can be opened
  std::span<const SceneCard> scene_cards;               ///< their cards, while the browser is shown
  std::span<const std::filesystem::path> recent_files;  ///< recently opened or saved, newest first
  std::span<const std::filesystem::path> macros;        ///< macros that can be played
  std::span<const SceneProblem> problems;               ///< problems of the current scene
  std::span<const std::string> export_hints;            ///< formats of exported runs
  std::filesystem::path scene_path;                     ///< file of the edited scene, may be empty
  TimeView time;                                        ///< the recorded past
  std::span<const RunSeries> series;                    ///< series that can be plotted
  RunCurves curves;                                     ///< plotted series, while plots are shown
  std::optional<MicrostepView> microsteps;              ///< recorded microsteps, while they are shown
  std::optional<ComparisonView> comparison;             ///< comparison with another branch at the same step
  double time_step = 0;                                 ///< in force [s]
  double step_milliseconds = 0;                         ///< smoothed duration of a step
  double step_in_progress = 0;                          ///< duration of the current step so far [s]
  double frames_per_second = 0;                         ///< drawn
  double reached_speed = 0;     ///< simulated seconds per second, smoothed; meaningful while running
  bool falling_behind = false;  ///< steps take longer than the requested speed allows
};

/// Everything that a panel needs to draw.
struct Panel {
  const EditorInput& input;
  EditorState& state;
  EditHistory& history;
  WidgetTags& tags;
  std::vector<Command>& commands;
  int view = 0;  ///< view over which is drawn, or in which the mouse is handled
};

/// Opens the next section if all sections are open or the sought field is in it. Call it before the section. `tag`: of
/// the section.
inline void open_if_sought(const Panel& panel, std::string_view tag) {
  const bool sought = panel.state.sought.frames > 0 && is_within(panel.state.sought.tag, tag);
  if (panel.state.open_sections || sought) ImGui::SetNextItemOpen(true);
}

/// Returns the reason why the command is disabled; empty if it is enabled.
std::string_view disabled_reason(const CommandInfo& info, const Panel& panel);
/// True if the state that the command toggles is on.
bool is_on(const CommandInfo& info, const Panel& panel);
/// True if the command is enabled.
bool command_enabled(const CommandInfo& info, const Panel& panel);
/// Returns the command of that name, which must exist.
const CommandInfo& command_info(std::string_view name, const Panel& panel);

/// Issues the command; if it is disabled, the program shows the reason.
void issue(Panel& panel, Command command);

}  // namespace griffith::ui
