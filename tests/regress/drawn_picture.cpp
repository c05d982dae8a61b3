#include "tests/regress/drawn_picture.h"

#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/named_view.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "app/picture/scene_legend.h"
#include "renderer/target.h"
#include "sim/world/world.h"
#include "tests/app/program.h"

namespace griffith::app {
namespace {

constexpr int kSteps = 6;
constexpr float kAspect = static_cast<float>(Drawer::kWidth) / Drawer::kHeight;

}  // namespace

Drawing drawing_of_wall(const std::string& view, const std::string& color_map, double density_factor) {
  Scene scene = small_wall();
  scene.bodies[0].material.density *= density_factor;
  World world(scene);
  for (int step = 0; step < kSteps; ++step) world.step();
  const Frame frame = world.frame();
  use_named_view(scene.view, view, frame, Vec3::UnitZ());
  scene.view.color_map = color_map;
  scene.view.splinters = false;
  const NodeId node(3);
  const ui::Selection selection = ui::select(frame, frame.nodes.stars[node].front(), node);
  Drawing drawing;
  drawing.scene = draw_scene_from_frame(frame, embedded_display(frame, scene), scene, scene.view, selection);
  drawing.camera = scene_camera(scene, "", drawing.scene, kAspect);
  drawing.labels = scene_labels(drawing.scene, drawing.camera, kAspect);
  drawing.state_hash = world.state_hash();
  return drawing;
}

RegressionPicture Drawer::draw(const Drawing& drawing) {
  renderer_.render(drawing.scene, drawing.camera, picture_options(kWidth, kHeight, 1, {}));
  RegressionPicture picture;
  picture.ids = renderer_.ids();
  const render::Target target(kWidth, kHeight);
  interface_.begin_frame(kWidth, kHeight);
  const ImVec2 size(kWidth, kHeight);
  ImDrawList* list = ImGui::GetBackgroundDrawList();
  const auto texture = static_cast<std::uintptr_t>(renderer_.color_texture());
  list->AddImage(reinterpret_cast<ImTextureID>(texture), {0, 0}, size, {0, 1}, {1, 0});
  ui::draw_labels(list, drawing.labels, interface_.fonts(), {0, 0}, size, kScale);
  if (const auto legend = scene_legend(drawing.scene, false))
    ui::draw_legend(list, *legend, interface_.fonts(), {{0, 0}, size}, kScale);
  target.bind();
  interface_.end_frame();
  picture.image = target.image();
  for (const ui::PictureLabel& label : drawing.labels) picture.text += label.text + "\n";
  picture.state_hash = drawing.state_hash;
  return picture;
}

}  // namespace griffith::app
