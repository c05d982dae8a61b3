#pragma once

#include <imgui.h>

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "sim/world/frame.h"
#include "ui/model/aim.h"
#include "ui/model/editor_state.h"
#include "ui/model/view_camera.h"
#include "ui/widgets/fonts.h"
#include "ui/widgets/labels.h"
#include "ui/widgets/legend.h"
#include "ui/widgets/widget_tags.h"

namespace griffith::ui {

/// What the panels read, new for every drawn frame.
struct EditorInput {
  Frame frame;
  Fonts fonts;
  ImTextureID picture = nullptr;                        ///< of the scene, bottom row first
  ViewCamera camera;                                    ///< of the picture
  std::optional<Legend> legend;                         ///< of the picture
  std::vector<PictureLabel> labels;                     ///< of the picture
  Aim aim;                                              ///< of the shot that is being aimed
  std::span<const UtilizationSample> utilizations;      ///< past of the selected node, oldest first
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();         ///< box round the bodies [m]
  Vec3 towards_eye = Vec3::UnitZ();                     ///< from what is looked at
  std::span<const std::filesystem::path> scene_files;   ///< offered for opening
  std::span<const SceneCard> scene_cards;               ///< of them, while the browser is shown
  std::span<const std::filesystem::path> recent_files;  ///< opened or saved last, newest first
  std::span<const std::filesystem::path> macros;        ///< that can be played
  std::span<const SceneProblem> problems;               ///< of the scene as it is
  std::filesystem::path scene_path;                     ///< of the scene being edited, may be empty
  TimeView time;                                        ///< the recorded past
  std::span<const RunSeries> series;                    ///< that can be plotted
  RunCurves curves;                                     ///< those that are, while plots are shown
  std::optional<ComparisonView> comparison;             ///< with another branch, at the same step
  double time_step = 0;                                 ///< in force [s]
  double step_milliseconds = 0;                         ///< of a step, smoothed
  double step_in_progress = 0;                          ///< how long the present step has taken so far [s]
  double frames_per_second = 0;                         ///< drawn
  double reached_speed = 0;     ///< simulated seconds per second, smoothed; of interest while running
  bool falling_behind = false;  ///< steps take longer than the wanted speed allows
};

/// What a panel draws with.
struct Panel {
  const EditorInput& input;
  EditorState& state;
  EditHistory& history;
  WidgetTags& tags;
  std::vector<Command>& commands;
};

/// To be called before a part that can be folded is drawn: it is open where all are to be, or where the sought field is
/// in it. `tag`: of the part.
inline void open_if_wanted(const Panel& panel, std::string_view tag) {
  const bool sought = panel.state.sought.frames > 0 && is_within(panel.state.sought.tag, tag);
  if (panel.state.open_sections || sought) ImGui::SetNextItemOpen(true);
}

/// Why the command makes no sense now; empty: it does.
std::string_view why_not(const CommandInfo& info, const Panel& panel);
/// Whether what the command toggles is on.
bool is_on(const CommandInfo& info, const Panel& panel);
/// Whether the command makes sense now.
bool command_enabled(CommandId id, const Panel& panel);

/// Issues the command; where it makes no sense now, the program says why.
void issue(Panel& panel, Command command);

}  // namespace griffith::ui
