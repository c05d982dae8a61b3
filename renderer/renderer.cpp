#include "renderer/renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "renderer/background_pass.h"
#include "renderer/blend_target.h"
#include "renderer/embedded_pass.h"
#include "renderer/glyph_pass.h"
#include "renderer/ground_pass.h"
#include "renderer/shadow_map.h"
#include "renderer/sphere_pass.h"
#include "renderer/stroke_pass.h"
#include "renderer/surface_pass.h"
#include "renderer/target.h"
#include "renderer/view.h"

namespace griffith::render {
namespace {

/// What matters in the picture: the scene, but for what has flown far from the target.
Focus focus_of(const Eigen::AlignedBox3f& box, const Camera& camera) {
  constexpr float kSmallest = 1e-3f, kLargest = 2.3f;  // [m], and in distances to the target
  const float limit = kLargest * (camera.position - camera.target).norm();
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(limit);
  const Eigen::AlignedBox3f near = box.intersection({camera.target - reach, camera.target + reach});
  if (near.isEmpty()) return {camera.target, limit};
  return {near.center(), std::max(0.5f * near.sizes().norm(), kSmallest)};
}

/// The ground fades out at this distance from the focus.
float ground_radius(const Focus& focus) { return 9 * focus.radius; }

/// The scene's box and the ground that is seen.
Eigen::AlignedBox3f visible_box(const DrawScene& scene, const Focus& focus, Eigen::AlignedBox3f box) {
  if (!scene.ground) return box;
  const float reach = ground_radius(focus);
  box.extend(Eigen::Vector3f(focus.center.x() - reach, scene.ground->height, focus.center.z() - reach));
  box.extend(Eigen::Vector3f(focus.center.x() + reach, scene.ground->height, focus.center.z() + reach));
  return box;
}

ViewBlock picture_view(const Camera& camera, const Eigen::AlignedBox3f& box, const Target& target,
                       const ViewBlock& shadow_view) {
  const float width = static_cast<float>(target.width()), height = static_cast<float>(target.height());
  ViewBlock block = shadow_view;
  block.view_projection = projection_matrix(camera, width / height, box) * view_matrix(camera);
  block.eye << camera.position, 1;
  block.viewport << width, height, static_cast<float>(target.samples()), 0;
  return block;
}

/// As the uniform block wants it: with a little room, so that what lies on the plane is drawn.
Vec4 visible_plane(const DrawScene& scene, float radius) {
  constexpr float kSlack = 1e-5f;
  if (!scene.visible) return Vec4::UnitW();
  const auto& [normal, offset] = *scene.visible;
  return {normal.x(), normal.y(), normal.z(), offset + kSlack * (radius + std::abs(offset))};
}

/// Everything the passes rely on, whoever drew before.
void set_state() {
  for (const GLenum off : {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB,
                           GL_SAMPLE_ALPHA_TO_COVERAGE, GL_PRIMITIVE_RESTART, GL_CLIP_DISTANCE0}) {
    glDisable(off);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(GL_TRUE);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
  glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

}  // namespace

struct Renderer::Passes {
  ViewBuffer shadow_view, picture_view;
  ShadowMap shadow_map;
  BackgroundPass background;
  ColorTables color_tables;
  SurfacePass surface;
  EmbeddedPass embedded;
  SpherePass spheres;
  GlyphPass glyphs;
  StrokePass strokes;
  GroundPass ground;
  Target target{1, 1};
  std::unique_ptr<BlendTarget> blend;  // of the target; none until something is transparent
  int requested_samples = 1;           // target.samples() may be fewer

  void resize(const RenderOptions& options);
  void upload(const DrawScene& scene, float pixel_scale);
  void draw_surfaces(const DrawScene& scene, const RenderOptions& options, Output output, DrawnPart part) const;
  void draw_transparent(const DrawScene& scene, const RenderOptions& options);
  /// `opaque`: surfaces cast shadows too.
  void draw_shadow_map(const ViewBlock& view, bool shadows, bool opaque) const;
  void draw_picture(const DrawScene& scene, const Camera& camera, const Focus& focus, const RenderOptions& options);
};

void Renderer::Passes::resize(const RenderOptions& options) {
  assert(options.width > 0 && options.height > 0 && options.samples > 0);
  if (target.width() == options.width && target.height() == options.height && requested_samples == options.samples) {
    return;
  }
  blend.reset();
  target = Target(options.width, options.height, options.samples);
  requested_samples = options.samples;
}

void Renderer::Passes::upload(const DrawScene& scene, float pixel_scale) {
  surface.upload(scene.surface);
  embedded.upload(scene.embedded);
  spheres.upload(scene.spheres);
  glyphs.upload(scene.glyphs);
  strokes.upload(scene, pixel_scale);
}

void Renderer::Passes::draw_shadow_map(const ViewBlock& view, bool shadows, bool opaque) const {
  shadow_map.begin();
  if (!shadows) return;
  shadow_view.bind(view);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(1.5f, 2);  // against self-shadowing
  if (opaque) {
    glEnable(GL_CLIP_DISTANCE0);
    surface.draw_shadow();
    embedded.draw_shadow();
    glDisable(GL_CLIP_DISTANCE0);
  }
  spheres.draw_shadow();
  glDisable(GL_POLYGON_OFFSET_FILL);
}

void Renderer::Passes::draw_surfaces(const DrawScene& scene, const RenderOptions& options, Output output,
                                     DrawnPart part) const {
  glEnable(GL_CLIP_DISTANCE0);
  surface.draw(scene.surface, color_tables, options, output, part);
  embedded.draw(scene.embedded, scene.surface.scalar_style, color_tables, options, scene.surface.opacity, output, part);
  glDisable(GL_CLIP_DISTANCE0);
}

void Renderer::Passes::draw_picture(const DrawScene& scene, const Camera& camera, const Focus& focus,
                                    const RenderOptions& options) {
  const bool see_through = scene.surface.opacity < 1;
  target.bind();
  target.clear(scene.background.bottom);
  shadow_map.bind();
  background.draw(scene.background);
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);  // the picture is opaque; alpha only blends
  draw_surfaces(scene, options, Output::opaque, see_through ? DrawnPart::selected : DrawnPart::all);
  spheres.draw();
  glyphs.draw(Output::opaque);
  if (scene.ground) {
    const bool from_below = camera.position.y() < scene.ground->height;
    ground.draw(*scene.ground, grid_level(height_at_target(camera)), focus.center, ground_radius(focus), from_below);
  }
  strokes.draw();
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (see_through || glyphs.has_transparent()) {
    draw_transparent(scene, options);
  } else {
    target.resolve();
  }
}

void Renderer::Passes::draw_transparent(const DrawScene& scene, const RenderOptions& options) {
  const bool see_through = scene.surface.opacity < 1;
  if (!blend) blend = std::make_unique<BlendTarget>(target);
  blend->begin();
  if (see_through) draw_surfaces(scene, options, Output::transparent, DrawnPart::unselected);
  glyphs.draw(Output::transparent);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  if (see_through) {  // what is seen through can be picked all the same
    target.bind();
    glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_surfaces(scene, options, Output::opaque, DrawnPart::unselected);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  target.resolve();
  blend->end();
}

Renderer::Renderer() : passes_(std::make_unique<Passes>()) {}
Renderer::~Renderer() = default;

void Renderer::render(const DrawScene& scene, const Camera& camera, const RenderOptions& options) {
  const BoundFramebuffer previous;
  const Eigen::AlignedBox3f box = bounds(scene);
  const Focus focus = focus_of(box, camera);
  ViewBlock shadow_view = ShadowMap::view(focus);
  shadow_view.visible = visible_plane(scene, focus.radius);
  set_state();
  passes_->resize(options);
  passes_->upload(scene, options.pixel_scale);
  passes_->draw_shadow_map(shadow_view, options.shadows, scene.surface.opacity == 1);
  passes_->picture_view.bind(picture_view(camera, visible_box(scene, focus, box), passes_->target, shadow_view));
  passes_->draw_picture(scene, camera, focus, options);
}

unsigned Renderer::color_texture() const { return passes_->target.color_texture(); }

Image Renderer::image() const { return passes_->target.image(); }

IdImage Renderer::ids() const { return passes_->target.ids(); }

std::int32_t Renderer::id_at(int x, int y) const { return passes_->target.id_at(x, y); }

}  // namespace griffith::render
