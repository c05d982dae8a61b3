#include "app/render/picture_maker.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <map>

#include "app/editor/imgui_context_owner.h"
#include "app/picture/draw_scene_from_frame.h"
#include "app/picture/exposure.h"
#include "app/picture/large_picture.h"
#include "app/picture/named_view.h"
#include "app/picture/picture_options.h"
#include "app/picture/scene_camera.h"
#include "app/picture/scene_legend.h"
#include "app/picture/steady_range.h"
#include "app/render/picture_text.h"
#include "renderer/target.h"

namespace griffith::app {
namespace {

/// largest scale for which fonts are rendered; beyond it they are magnified
constexpr float kLargestFont = 6;

/// Returns the direction from the camera's target to the eye, before there is a picture.
Vec3 toward_eye(const Scene& scene, const std::string& camera) {
  for (const Camera& known : scene.cameras)
    if (camera.empty() || known.name == camera) return known.position - known.target;
  return Vec3::UnitZ();
}

constexpr render::Background kBlack = {{0, 0, 0}, {0, 0, 0}}, kWhite = {{1, 1, 1}, {1, 1, 1}};

void put_under_sky(render::DrawScene& drawn) {
  drawn.environment.kind = render::Environment::Kind::sky;
  if (drawn.ground) drawn.ground->color = {0.43f, 0.40f, 0.355f};  // weathered concrete, warmer than a hall's
  drawn.background = {{0.42f, 0.56f, 0.75f}, {0.74f, 0.79f, 0.84f}, true};
}

/// Shows objects before a plain background, without the ground.
void put_before(const render::Background& background, render::DrawScene& drawn) {
  if (drawn.ground) drawn.ground->drawn = false;
  drawn.background = background;
}

/// Returns the picture without its background, from pictures on black and on white (A. R. Smith and J. F. Blinn 1996,
/// "Blue Screen Matting", theorem 4): the difference of the two is the transparency.
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

}  // namespace

struct PictureMaker::Impl {
  /// A camera and a view with their constant state.
  struct Viewpoint {
    ViewSettings view;
    SteadyRange range;
    render::Camera camera;
    ui::LegendCorner corner = {};  ///< corner that is free in the first picture, so that the legend does not move
  };

  /// Text over a picture.
  struct Writing {
    std::optional<ui::Legend> legend;
    std::vector<ui::PictureLabel> labels;
  };

  Impl(const RenderJob& render_job, const Scene& of_scene, const World& start)
      : job(render_job),
        scene(of_scene),
        display(embedded_display(start.frame(), scene)),
        scale(writing_scale(job.width, job.height)),
        imgui(std::min(scale, kLargestFont)) {
    for (const std::string& camera : job.cameras)
      for (const std::string& view : job.views)
        viewpoints.emplace(std::pair(camera, view), viewpoint(start.frame(), camera, view));
  }

  ImVec2 size() const { return {static_cast<float>(job.width), static_cast<float>(job.height)}; }
  float aspect() const { return size().x / size().y; }

  Viewpoint viewpoint(const Frame& frame, const std::string& camera, const std::string& view) const {
    Viewpoint result;
    result.view = scene.view;
    use_named_view(result.view, view, frame, toward_eye(scene, camera));
    result.range.follow(frame, result.view.quantity);
    const render::DrawScene first = draw_scene(frame, result);
    result.camera = scene_camera(scene, camera, first, aspect());
    if (const auto legend = scene_legend(first, false))
      result.corner = legend_corner(first, result.camera, *legend, imgui.fonts(), size(), scale);
    return result;
  }

  render::RenderOptions options_of(const Viewpoint& viewpoint) const {
    // Exposures of a poster differ by parts of a pixel: together they smooth edges.
    const std::optional<int> usual = job.poster ? std::optional(1) : std::nullopt;
    return picture_options(job.width, job.height, job.samples ? job.samples : usual, viewpoint.view);
  }

  /// Draws the mean of many exposures of a part. `matte`: instead of ground and background.
  PaintedPicture exposed_part(const Frame& frame, const Viewpoint& viewpoint,
                              const std::optional<render::Background>& matte, const render::RenderOptions& part) {
    const double open = kShutter * scene.simulation.time_step;
    ImageSum sum;
    render::DrawScene drawn;
    double time = 1;  // of `drawn`: none yet
    for (const Exposure& exposure : exposures(kPosterExposures, kPosterTimes)) {
      if (exposure.time != time) drawn = draw_scene(LaterFrame(frame, open * exposure.time).frame(), viewpoint);
      if (matte) put_before(*matte, drawn);
      time = exposure.time;
      renderer.render(drawn, exposed(viewpoint.camera, exposure, job.height), part);
      sum.add(renderer.image());
    }
    return {sum.mean(), renderer.ids()};
  }

  PaintedPicture poster(const Frame& frame, const Viewpoint& viewpoint,
                        const std::optional<render::Background>& matte) {
    return paint_in_parts(options_of(viewpoint), job.largest_part, [&](const render::RenderOptions& part) {
      return exposed_part(frame, viewpoint, matte, part);
    });
  }

  render::DrawScene draw_scene(const Frame& frame, const Viewpoint& viewpoint) const {
    render::DrawScene drawn = draw_scene_from_frame(frame, display, scene, viewpoint.view, selected_node(job, frame),
                                                    viewpoint.range.range());
    if (job.sky) put_under_sky(drawn);
    return drawn;
  }

  Writing writing_of(const Frame& frame, const render::DrawScene& drawn, const Viewpoint& viewpoint) const {
    if (!job.legend) return {};
    Writing writing{scene_legend(drawn, viewpoint.view.range.has_value()),
                    scene_labels(drawn, viewpoint.camera, aspect())};
    constexpr float kAboveEdge = 16;  // design pixels
    if (const auto scaling = scaling_label(scene, frame, 1 - kAboveEdge * scale / size().y))
      writing.labels.push_back(*scaling);
    if (!ui::legend_fits({{0, 0}, size()}, scale)) writing.legend.reset();
    if (writing.legend) writing.legend->corner = viewpoint.corner;
    return writing;
  }

  void add_caption(const std::string& text, Writing& writing) const {
    constexpr float kBelowEdge = 20;  // design pixels
    writing.labels.push_back({0.5f, kBelowEdge * scale / size().y, text});
  }

  PaintedPicture image(const render::DrawScene& drawn, const Viewpoint& viewpoint, const Writing& writing) {
    const bool has_text = writing.legend || !writing.labels.empty();
    return paint_in_parts(options_of(viewpoint), job.largest_part, [&](const render::RenderOptions& part) {
      renderer.render(drawn, viewpoint.camera, part);
      return PaintedPicture{has_text ? written_over(writing, part) : renderer.image(), renderer.ids()};
    });
  }

  PaintedPicture without_background(render::DrawScene drawn, const Viewpoint& viewpoint, const Writing& writing) {
    put_before(kBlack, drawn);
    PaintedPicture picture = image(drawn, viewpoint, writing);
    put_before(kWhite, drawn);
    picture.image = matted(picture.image, image(drawn, viewpoint, writing).image);
    return picture;
  }

  PaintedPicture poster(const Frame& frame, const Viewpoint& viewpoint) {
    if (!job.transparent) return poster(frame, viewpoint, std::nullopt);
    PaintedPicture picture = poster(frame, viewpoint, kBlack);
    picture.image = matted(picture.image, poster(frame, viewpoint, kWhite).image);
    return picture;
  }

  /// Returns the last picture, a part of the whole one, with text over it.
  render::Image written_over(const Writing& writing, const render::RenderOptions& part) {
    const render::PicturePart place = part.part.value_or(render::PicturePart{});
    const ImVec2 corner(static_cast<float>(place.left), static_cast<float>(place.top));
    const ImVec2 extent(static_cast<float>(part.width), static_cast<float>(part.height));
    imgui.begin_frame(job.width, job.height);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const auto texture = static_cast<std::uintptr_t>(renderer.color_texture());
    list->AddImage(reinterpret_cast<ImTextureID>(texture), corner, {corner.x + extent.x, corner.y + extent.y}, {0, 1},
                   {1, 0});
    ui::draw_labels(list, writing.labels, imgui.fonts(), {0, 0}, size(), scale);
    if (writing.legend) ui::draw_legend(list, *writing.legend, imgui.fonts(), {{0, 0}, size()}, scale);
    if (!target || target->width() != part.width || target->height() != part.height)
      target.emplace(part.width, part.height);
    target->bind();
    imgui.end_frame(corner, extent);
    return target->image();
  }

  RenderJob job;
  Scene scene;
  EmbeddedDisplay display;
  float scale;  ///< scale of text
  render::Renderer renderer;
  ImGuiContextOwner imgui;
  std::optional<render::Target> target;                                 ///< as large as the last part with text
  std::map<std::pair<std::string, std::string>, Viewpoint> viewpoints;  ///< by camera and view
};

PictureMaker::PictureMaker(const RenderJob& job, const Scene& scene, const World& start)
    : impl_(std::make_unique<Impl>(job, scene, start)) {}
PictureMaker::~PictureMaker() = default;

void PictureMaker::follow(const World& world) {
  follow_first_cracks(impl_->display, world.frame(), impl_->scene);
  for (auto& [names, viewpoint] : impl_->viewpoints) viewpoint.range.follow(world.frame(), viewpoint.view.quantity);
}

RenderedPicture PictureMaker::paint(const World& world, const std::string& camera, const std::string& view, double turn,
                                    const std::string& caption) {
  Impl::Viewpoint viewpoint = impl_->viewpoints.at({camera, view});
  if (turn != 0) viewpoint.camera = render::orbit(viewpoint.camera, static_cast<float>(turn), 0);
  RenderedPicture picture;
  picture.record = world_record(world);
  PaintedPicture painted;
  if (impl_->job.poster) {
    painted = impl_->poster(world.frame(), viewpoint);
  } else {
    const render::DrawScene drawn = impl_->draw_scene(world.frame(), viewpoint);
    Impl::Writing writing = impl_->writing_of(world.frame(), drawn, viewpoint);
    if (impl_->job.legend && !caption.empty()) impl_->add_caption(caption, writing);
    picture.record.text = writing_text(writing.legend, writing.labels);
    painted = impl_->job.transparent ? impl_->without_background(drawn, viewpoint, writing)
                                     : impl_->image(drawn, viewpoint, writing);
  }
  picture.image = std::move(painted.image);
  picture.ids = std::move(painted.ids);
  return picture;
}

ui::Selection selected_node(const RenderJob& job, const Frame& frame) {
  if (!job.node) return {};
  const auto nodes = static_cast<int>(frame.nodes.positions.size());
  if (*job.node >= nodes && frame.step >= job.frames.back())
    throw InputError("--node", "there is no node " + std::to_string(*job.node),
                     "use one below " + std::to_string(nodes) + "; cracks make more");
  if (*job.node >= nodes) return {};
  const NodeId node(*job.node);
  return ui::select(frame, frame.nodes.stars[node].front(), node);
}

PictureRecord world_record(const World& world) {
  const Frame frame = world.frame();
  PictureRecord record;
  record.frame = static_cast<int>(frame.step);
  record.state_hash = world.state_hash();
  record.statistics = {{"pieces", static_cast<double>(frame.bodies.size())},
                       {"crack_events", static_cast<double>(frame.crack_events.size())},
                       {"nodes", static_cast<double>(frame.nodes.positions.size())},
                       {"kinetic_energy", frame.totals.kinetic_energy},
                       {"elastic_energy", frame.totals.elastic_energy},
                       {"crack_area", frame.energy.crack_area}};
  return record;
}

}  // namespace griffith::app
