#include <algorithm>
#include <new>
#include <stdexcept>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/picking.h"
#include "app/editor/shooting.h"
#include "app/picture/bulk_bounds.h"
#include "sim/world/node_report.h"
#include "ui/model/entry_choice.h"
#include "ui/model/verdict.h"

namespace griffith::app {
using ui::CommandId;

void Editor::execute(const ui::Command& command) {
  if (const std::string_view reason = disabled_reason(command.id); !reason.empty()) return refuse(command.id, reason);
  const bool leaves =
      command.id == CommandId::new_scene || command.id == CommandId::open || command.id == CommandId::quit;
  if (leaves && history_.modified() && !command.discard_edits) {
    state_.unsaved = command;
    return;
  }
  note_for_macro();
  try {
    carry_out(command);
    if (recorder_) recorder_->add(command, macro_moment());
  } catch (const InputError& error) {
    show_error(error);
  }
}

void Editor::refuse(CommandId id, std::string_view reason) {
  const std::string text = std::string(ui::command_info(id).label) + ": " + std::string(reason);
  const bool said = !state_.log.empty() && state_.log.back().text == text;
  if (said) state_.log_seen = std::min(state_.log_seen, state_.log.size() - 1);
  if (!said) log(ui::LogLevel::warning, text, ui::LogSpan::action);
}

void Editor::toggle_run() {
  state_.running = !state_.running;
  state_.steps_left = 0;
  reset_pace();
}

void Editor::make_steps(std::int64_t count) {
  state_.running = count > 0;
  state_.steps_left = count;
  reset_pace();
}

void Editor::pause_and_step() {
  state_.running = false;
  step();
}

void Editor::show_error(const InputError& error) {
  state_.running = false;
  discard_queued_commands();
  state_.error = ui::ErrorMessage{error.where(), error.problem(), error.remedy()};
  log(ui::LogLevel::error, error.what());
}

double Editor::max_tets() const {
  constexpr double kMany = 4e5;
  return std::max(kMany, 2.0 * static_cast<double>(world().frame().elements.tets.size()));
}

void Editor::discard_queued_commands() {
  for (const ui::Command& command : std::exchange(state_.waiting, {}))
    log(ui::LogLevel::warning,
        std::string(ui::command_info(command.id).label) + " was skipped: the work before it failed.");
}

void Editor::receive_world() {
  if (state_.cancel_work) discard_queued_commands();
  constexpr double kTravelTime = 0.03;  // fraction of a drawn frame [s]
  continue_travel(kTravelTime);
  go_on_with_export();
  go_on_with_holding();
  if (state_.cancel_work) {
    loader_.cancel();
    end_work();
  }
  if (state_.build_large_mesh) loader_.start_again();
  state_.cancel_work = state_.build_large_mesh = false;
  try {
    if (std::optional<WorldLoader::Loaded> loaded = loader_.take()) {
      take_world(std::move(*loaded));
      if (recorder_) recorder_->skip(macro_moment());
    }
  } catch (const InputError& error) {
    end_work();
    show_error(error);
  } catch (const LargeMesh& mesh) {
    state_.large_mesh = mesh.tets;
  } catch (const std::bad_alloc&) {
    end_work();
    show_error(InputError("the scene", "cannot be built: out of memory", "use larger elements or fewer bodies"));
  } catch (const std::runtime_error& error) {
    end_work();
    show_error(InputError("the scene", std::string("cannot be built: ") + error.what(), ""));
  }
  state_.work = travel_ ? travel_stage() : export_ ? export_->stage() : holding_ ? holding_->stage() : loader_.stage();
}

void Editor::end_work() {
  if (loader_.reason() == LoadReason::follow) {
    go_back_to_built();
  } else {
    seen_revision_ = -1;  // it may have replaced a world that was to follow an edit
  }
}

void Editor::take_world(WorldLoader::Loaded loaded) {
  if (loaded.reason == LoadReason::follow) return take_followed(std::move(loaded));
  timeline_ = Timeline(std::move(loaded.world));
  built_at_ = loaded.started;
  warnings_ = std::move(loaded.warnings);
  display_ = CopyOnWrite(std::move(loaded.display));
  if (loaded.reason == LoadReason::recover) return show_recovered(std::move(loaded.scene), loaded.path);
  if (loaded.reason == LoadReason::open) {
    if (autosave_) autosave_->remove();
    file_time_ = opened_time_;
    show_scene(std::move(loaded.scene), std::move(loaded.path));
    remember_file();
    return offer_recovery(false);
  }
  history_.change("Add body", [&](Scene& scene) { scene.bodies = loaded.scene.bodies; });
  history_.finish();
  ui::select_entries(state_, history_.scene(),
                     {{ui::EntryKind::body, static_cast<int>(loaded.scene.bodies.size()) - 1}});
  restart();
  report_surface();
}

Editor::AimedShot Editor::aimed_at(const Vec2& cursor) const {
  const PictureKey key = picture_key();
  const render::Ray ray = render::pixel_ray(picture_camera(), static_cast<float>(cursor.x() * key.width),
                                            static_cast<float>(cursor.y() * key.height), key.width, key.height);
  const Vec3 direction = ray.direction.cast<double>(), eye = ray.origin.cast<double>();
  const double way = surface_hit(world().frame(), history_.scene().ground, eye, direction)
                         .value_or((camera_.target - camera_.position).norm());
  // It starts below the eye, far enough ahead not to cover the picture.
  const double ahead = std::min(4 * state_.shot.radius, way / 2);
  const Vec3 muzzle = eye + ahead * direction - 2 * state_.shot.radius * Vec3::UnitY();
  const Vec3 target = eye + way * direction;
  return {aimed_shot(state_.shot, muzzle, target, history_.scene().gravity), target};
}

ui::Aim Editor::aim() const {
  if (!state_.aimed_at) return {};
  const auto [shot, target] = aimed_at(*state_.aimed_at);
  return flight_of(shot, target, history_.scene().gravity, world().frame(), history_.scene().ground);
}

void Editor::fire(const Vec2& cursor) {
  ProjectileBurst shot = aimed_at(cursor).shot;
  timeline_.fire(shot);
  leave_state();
  shot.start = world().frame().time;
  state_.last_shot = shot;
  if (!state_.running) log(ui::LogLevel::info, "Fired. Press Space to run the simulation.", ui::LogSpan::action);
}

void Editor::select(const ui::Selection& selection) {
  const Frame frame = world().frame();
  state_.selection = selection;
  if (selection.valid()) state_.selected_body = frame.bodies[frame.elements.bodies[selection.tet]].scene_body;
}

void Editor::select_node(NodeId node) {
  const Frame frame = world().frame();
  if (!node.valid() || static_cast<std::size_t>(node) >= frame.nodes.positions.size()) return;
  select(ui::select(frame, frame.nodes.stars[node].front(), node));
}

void Editor::select_most_loaded() {
  const NodeId node = most_loaded_node(world().frame());
  if (node.valid()) return select_node(node);
  log(ui::LogLevel::warning, std::string("No node carries a load: ") + ui::kNothingStrained, ui::LogSpan::state);
}

void Editor::pick(const Vec2& cursor) {
  state_.entries.clear();
  const float x = static_cast<float>(cursor.x() * drawn_.width), y = static_cast<float>(cursor.y() * drawn_.height);
  const std::int32_t id = renderer_.id_at(static_cast<int>(x), static_cast<int>(y));
  state_.selection = {};
  if (id < 0) return;
  const Frame frame = world().frame();
  if (static_cast<std::size_t>(id) >= frame.elements.tets.size()) return;
  const render::Ray ray = render::pixel_ray(picture_camera(), x, y, drawn_.width, drawn_.height);
  const ShownMesh shown = shown_mesh(frame, state_.view, {}, hidden_bodies());
  select(ui::select(frame, TetId(id), nearest_corner(shown, TetId(id), ray)));
}

void Editor::frame_all() {
  const Eigen::AlignedBox3f bulk = bulk_bounds(shown_mesh(world().frame(), state_.view, {}, hidden_bodies()));
  look_at(bulk.isEmpty() ? render::bounds(picture_) : bulk);
}

void Editor::toggle_slice() {
  if (state_.view.slice) {
    state_.view.slice.reset();
  } else {
    use_view("slice");
  }
}

void Editor::toggle_range_lock() {
  if (state_.view.range) {
    state_.view.range.reset();
  } else if (!picture_.surface.scalar_style.quantity.empty()) {
    const render::ScalarStyle& style = picture_.surface.scalar_style;
    state_.view.range = Vec2(style.minimum, style.maximum);
  }
}

}  // namespace griffith::app
