#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <map>

#include "app/editor/imgui_context_owner.h"
#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/named_view.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "app/picture/scene_legend.h"
#include "app/picture/steady_range.h"
#include "app/render/painter.h"
#include "app/render/picture_text.h"
#include "app/shared/scene_world.h"
#include "renderer/target.h"

namespace griffith::app {
namespace {

/// The largest scale that letters are made for; beyond it they are stretched.
constexpr float kLargestFont = 6;

/// Direction from what is looked at to the eye, before there is a picture.
Vec3 towards_eye(const Scene& scene, const std::string& camera) {
  for (const Camera& known : scene.cameras)
    if (camera.empty() || known.name == camera) return known.position - known.target;
  return Vec3::UnitZ();
}

/// A camera and a view, with what stays the same from picture to picture.
struct Viewpoint {
  ViewSettings view;
  SteadyRange range;
  render::Camera camera;
  ui::LegendCorner corner = {};  ///< where the first picture leaves room, so that it does not hop about
};

/// What is written over a picture.
struct Writing {
  std::optional<ui::Legend> legend;
  std::vector<ui::PictureLabel> labels;
};

/// The picture without its background, from pictures before black and before white (A. R. Smith and J. F. Blinn 1996,
/// "Blue Screen Matting", theorem 4): what of white does not come through is the opacity.
render::Image matted(const render::Image& on_black, const render::Image& on_white) {
  render::Image result = on_black;
  for (std::size_t pixel = 0; pixel < result.rgba.size(); pixel += 4) {
    int transparency = 0;
    for (std::size_t c = pixel; c < pixel + 3; ++c)
      transparency = std::max(transparency, on_white.rgba[c] - on_black.rgba[c]);
    const int alpha = 255 - transparency;
    for (std::size_t c = pixel; c < pixel + 3; ++c)
      result.rgba[c] =
          static_cast<std::uint8_t>(alpha > 0 ? std::min(255, (on_black.rgba[c] * 255 + alpha / 2) / alpha) : 0);
    result.rgba[pixel + 3] = static_cast<std::uint8_t>(alpha);
  }
  return result;
}

class PlainPainter : public Painter {
 public:
  PlainPainter(const RenderJob& job, const Scene& scene)
      : job_(job),
        scene_(scene),
        world_(make_world(scene, job.scene)),
        display_(embedded_display(world_.frame(), scene)),
        scale_(writing_scale(job.width, job.height)),
        imgui_(std::min(scale_, kLargestFont)),
        target_(job.width, job.height) {
    for (const std::string& camera : job.cameras)
      for (const std::string& view : job.views) viewpoints_.emplace(std::pair(camera, view), viewpoint(camera, view));
  }

  void step() override {
    world_.step();
    follow_first_cracks(display_, world_.frame(), scene_);
    for (auto& [names, viewpoint] : viewpoints_) viewpoint.range.follow(world_.frame(), viewpoint.view.quantity);
  }

  const World& world() const override { return world_; }

  RenderedPicture paint(const std::string& camera, const std::string& view) override {
    const Viewpoint& viewpoint = viewpoints_.at({camera, view});
    const render::DrawScene drawn = draw_scene(viewpoint);
    const Writing writing = writing_of(drawn, viewpoint);
    RenderedPicture picture;
    picture.record = world_record(world_);
    picture.record.text = writing_text(writing.legend, writing.labels);
    picture.image = job_.transparent ? without_background(drawn, viewpoint, writing) : image(drawn, viewpoint, writing);
    picture.ids = renderer_.ids();
    return picture;
  }

 private:
  ImVec2 size() const { return {static_cast<float>(job_.width), static_cast<float>(job_.height)}; }
  float aspect() const { return size().x / size().y; }

  Viewpoint viewpoint(const std::string& camera, const std::string& view) const {
    Viewpoint result;
    result.view = scene_.view;
    use_named_view(result.view, view, world_.frame(), towards_eye(scene_, camera));
    result.range.follow(world_.frame(), result.view.quantity);
    const render::DrawScene first = draw_scene(result);
    result.camera = scene_camera(scene_, camera, first, aspect());
    if (const auto legend = scene_legend(first, false))
      result.corner = legend_corner(first, result.camera, *legend, imgui_.fonts(), size(), scale_);
    return result;
  }

  render::DrawScene draw_scene(const Viewpoint& viewpoint) const {
    const Frame frame = world_.frame();
    return draw_scene_from_frame(frame, display_, scene_, viewpoint.view, selected_node(job_, frame),
                                 viewpoint.range.range());
  }

  Writing writing_of(const render::DrawScene& drawn, const Viewpoint& viewpoint) const {
    if (!job_.legend) return {};
    Writing writing{scene_legend(drawn, viewpoint.view.range.has_value()),
                    scene_labels(drawn, viewpoint.camera, aspect())};
    constexpr float kAboveEdge = 16;  // design pixels
    if (const auto scaling = scaling_label(scene_, world_.frame(), 1 - kAboveEdge * scale_ / size().y))
      writing.labels.push_back(*scaling);
    if (!ui::legend_fits({{0, 0}, size()}, scale_)) writing.legend.reset();
    if (writing.legend) writing.legend->corner = viewpoint.corner;
    return writing;
  }

  render::Image image(const render::DrawScene& drawn, const Viewpoint& viewpoint, const Writing& writing) {
    renderer_.render(drawn, viewpoint.camera, picture_options(job_.width, job_.height, job_.samples, viewpoint.view));
    return writing.legend || !writing.labels.empty() ? written_over(writing) : renderer_.image();
  }

  render::Image without_background(render::DrawScene drawn, const Viewpoint& viewpoint, const Writing& writing) {
    drawn.ground.reset();
    drawn.background = {{0, 0, 0}, {0, 0, 0}};
    const render::Image on_black = image(drawn, viewpoint, writing);
    drawn.background = {{1, 1, 1}, {1, 1, 1}};
    return matted(on_black, image(drawn, viewpoint, writing));
  }

  /// The last picture with the writing over it.
  render::Image written_over(const Writing& writing) {
    imgui_.begin_frame(job_.width, job_.height);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const auto texture = static_cast<std::uintptr_t>(renderer_.color_texture());
    list->AddImage(reinterpret_cast<ImTextureID>(texture), {0, 0}, size(), {0, 1}, {1, 0});
    ui::draw_labels(list, writing.labels, imgui_.fonts(), {0, 0}, size(), scale_);
    if (writing.legend) ui::draw_legend(list, *writing.legend, imgui_.fonts(), {{0, 0}, size()}, scale_);
    target_.bind();
    imgui_.end_frame();
    return target_.image();
  }

  RenderJob job_;
  Scene scene_;
  World world_;
  EmbeddedDisplay display_;
  float scale_;  ///< of what is written
  render::Renderer renderer_;
  ImGuiContextOwner imgui_;
  render::Target target_;
  std::map<std::pair<std::string, std::string>, Viewpoint> viewpoints_;  ///< by camera and view
};

}  // namespace

std::unique_ptr<Painter> make_plain_painter(const RenderJob& job, const Scene& scene) {
  return std::make_unique<PlainPainter>(job, scene);
}

}  // namespace griffith::app
