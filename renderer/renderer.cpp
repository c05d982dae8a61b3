#include "renderer/renderer.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "renderer/embedded_pass.h"
#include "renderer/glyph_pass.h"
#include "renderer/hidden_backs.h"
#include "renderer/material_table.h"
#include "renderer/picture_buffers.h"
#include "renderer/puff_pass.h"
#include "renderer/shadow_map.h"
#include "renderer/sphere_pass.h"
#include "renderer/stroke_pass.h"
#include "renderer/surface_pass.h"
#include "renderer/surroundings.h"
#include "renderer/view.h"

namespace griffith::render {
namespace {

/// Returns the focus of the picture: the scene without objects far from the target.
Focus focus_of(const Eigen::AlignedBox3f& box, const Camera& camera) {
  constexpr float kSmallest = 1e-3f, kLargest = 2.3f;  // [m], and in distances to the target
  constexpr float kLongLens = 12;                      // heights of the picture; what it shows is nearer to the target
  const float distance = std::min((camera.position - camera.target).norm(), kLongLens * height_at_target(camera));
  const float limit = kLargest * distance;
  const Eigen::Vector3f reach = Eigen::Vector3f::Constant(limit);
  const Eigen::AlignedBox3f near = box.intersection({camera.target - reach, camera.target + reach});
  if (near.isEmpty()) return {camera.target, limit};
  return {near.center(), std::max(0.5f * near.sizes().norm(), kSmallest)};
}

/// Radius around the focus at which the ground has faded out.
float ground_radius(const Focus& focus) { return 9 * focus.radius; }

/// Returns the scene's bounding box including distant objects and the visible ground.
Eigen::AlignedBox3f visible_box(const DrawScene& scene, const Focus& focus, Eigen::AlignedBox3f box) {
  for (const Sphere& crumb : scene.crumbs) box.extend(crumb.center);
  for (const Puff& puff : scene.puffs) {
    box.extend((puff.center.array() - puff.radius).matrix());
    box.extend((puff.center.array() + puff.radius).matrix());
  }
  if (!scene.ground) return box;
  const float reach = ground_radius(focus);
  box.extend(Eigen::Vector3f(focus.center.x() - reach, scene.ground->height, focus.center.z() - reach));
  box.extend(Eigen::Vector3f(focus.center.x() + reach, scene.ground->height, focus.center.z() + reach));
  return box;
}

/// Effects of a quality.
struct Effects {
  float penumbra = 0;          ///< width relative to the distance of the occluder
  int shadow_samples = 0;      ///< samples of a penumbra
  int occlusion_samples = 0;   ///< 0: no ambient occlusion
  int occlusion_fraction = 1;  ///< ratio of the picture's size to that of its occlusion map
};

Effects effects_of(Quality quality) {
  if (quality == Quality::standard) return {0.07f, 16, 12, 2};
  if (quality == Quality::high) return {0.07f, 48, 32, 1};
  return {};
}

/// Returns the picture of which a part is drawn, or all of it.
PicturePart whole_of(const RenderOptions& options) {
  return options.part.value_or(PicturePart{0, 0, options.width, options.height});
}

/// Returns the side of the shadow map in texels. In a draft a texel need not be smaller than a pixel at the camera's
/// target.
int shadow_texels(const Focus& focus, const Camera& camera, const RenderOptions& options) {
  if (options.quality != Quality::draft) return ShadowMap::kMostTexels;
  const float pixel = height_at_target(camera) / static_cast<float>(whole_of(options).whole_height);  // [m]
  const float texels = std::min(2 * focus.radius / pixel, static_cast<float>(ShadowMap::kMostTexels));
  return static_cast<int>(std::bit_ceil(static_cast<unsigned>(std::ceil(texels))));
}

/// Returns the light from the lit ground, and from the floor of a room without one; w: strength of the environment.
Vec4 surroundings_of(const DrawScene& scene) {
  constexpr float kGroundLight = 0.75f;  // mean illumination of the ground
  const Rgb color = scene.ground ? scene.ground->color : Rgb{0.35f, 0.35f, 0.35f};
  const auto light = [](float channel) { return kGroundLight * linear_from_srgb(channel); };
  return {light(color.r), light(color.g), light(color.b), scene.environment.strength};
}

/// Returns the transform of clip space that leaves the drawn part of the picture alone.
Mat4 crop(const RenderOptions& options) {
  const auto [left, top, width, height] = whole_of(options);
  const int bottom = height - top - options.height;
  Mat4 transform = Mat4::Identity();
  const auto cut = [&](int axis, int start, int part, int whole) {
    transform(axis, axis) = static_cast<float>(whole) / static_cast<float>(part);
    transform(axis, 3) = static_cast<float>(whole - 2 * start - part) / static_cast<float>(part);
  };
  cut(0, left, options.width, width);
  cut(1, bottom, options.height, height);
  return transform;
}

ViewBlock picture_view(const Camera& camera, const Eigen::AlignedBox3f& box, const Target& target,
                       const RenderOptions& options, const ViewBlock& shadow_view, const Effects& effects) {
  const PicturePart whole = whole_of(options);
  const float width = static_cast<float>(target.width()), height = static_cast<float>(target.height());
  const float whole_width = static_cast<float>(whole.whole_width),
              whole_height = static_cast<float>(whole.whole_height);
  ViewBlock block = shadow_view;
  const Mat4 projection = projection_matrix(camera, whole_width / whole_height, box);
  block.view_projection = (options.part ? crop(options) * projection : projection) * view_matrix(camera);
  block.eye << camera.position, 1;
  block.viewport << width, height, static_cast<float>(target.samples()), whole_height / height;
  block.effects << effects.penumbra, static_cast<float>(effects.shadow_samples), 0, 0;
  return block;
}

/// Returns the visible half-space for the uniform block, with a margin so that objects on the plane are drawn.
Vec4 visible_plane(const DrawScene& scene, float radius) {
  constexpr float kSlack = 1e-5f;
  if (!scene.visible) return Vec4::UnitW();
  const auto& [normal, offset] = *scene.visible;
  return {normal.x(), normal.y(), normal.z(), offset + kSlack * (radius + std::abs(offset))};
}

/// True if some drawn material is transparent.
bool has_glass(const DrawScene& scene, const RenderOptions& options) {
  if (options.quality == Quality::draft || scene.surface.opacity < 1) return false;
  const EmbeddedSurface& embedded = scene.embedded;
  const bool natural = embedded.mesh && embedded.scalars.empty() && embedded.piece_colors.empty();
  return (natural && std::ranges::any_of(embedded.materials, [](const auto& m) { return m.clear_depth > 0; })) ||
         std::ranges::any_of(scene.surface.flags, [](std::uint8_t flags) { return flags & kClear; });
}

/// Culls back faces during its lifetime.
class Culling {
 public:
  explicit Culling(bool culls) {
    if (culls) glEnable(GL_CULL_FACE);
  }
  ~Culling() { glDisable(GL_CULL_FACE); }
  Culling(const Culling&) = delete;
  Culling& operator=(const Culling&) = delete;
};

/// Returns the part that is drawn as opaque.
DrawnPart opaque_part(const DrawScene& scene, bool glass) {
  if (glass) return DrawnPart::not_clear;
  return scene.surface.opacity < 1 ? DrawnPart::selected : DrawnPart::all;
}

/// Sets all OpenGL state on which the passes rely.
void set_state() {
  for (const GLenum off : {GL_BLEND, GL_CULL_FACE, GL_SCISSOR_TEST, GL_STENCIL_TEST, GL_FRAMEBUFFER_SRGB,
                           GL_SAMPLE_ALPHA_TO_COVERAGE, GL_PRIMITIVE_RESTART, GL_CLIP_DISTANCE0, GL_DEPTH_CLAMP}) {
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
  ShadowMap shadow_map, clear_shadow_map;
  BackgroundPass background;
  ColorTables color_tables;
  MaterialTable materials;
  SurfacePass surface;
  EmbeddedPass embedded;
  SpherePass spheres, crumbs{SpherePass::Shape::chip};
  PuffPass puffs;
  GlyphPass glyphs;
  StrokePass strokes;
  GroundPass ground;
  HiddenBacks hidden;    // from the eye
  Mat4 world_from_clip;  // inverse of the picture's projection
  std::vector<std::unique_ptr<PictureBuffers>> pictures;
  PictureBuffers* picture = nullptr;  // the one being drawn

  void begin_picture(std::size_t index, const RenderOptions& options);
  void upload(const DrawScene& scene, float pixel_scale);
  void draw_surfaces(const DrawScene& scene, const RenderOptions& options, Output output, DrawnPart part) const;
  void add_up_glass(const DrawScene& scene, const RenderOptions& options);
  void draw_transparent(const DrawScene& scene, const RenderOptions& options);
  /// Draws only the depth of opaque parts.
  void draw_depths(const DrawScene& scene, const RenderOptions& options, const HiddenBacks& backs) const;
  void draw_depths_of_surfaces(DrawnPart part, const HiddenBacks& backs) const;
  void draw_shadow_maps(const DrawScene& scene, const ViewBlock& view, const RenderOptions& options, int texels);
  void draw_occlusion_map(const DrawScene& scene, const Camera& camera, const Focus& focus, const Mat4& view_projection,
                          const RenderOptions& options);
  void draw_ground(const DrawScene& scene, const Camera& camera, const Focus& focus, Light light) const;
  void draw_picture(const DrawScene& scene, const Camera& camera, const Focus& focus, const RenderOptions& options);
};

void Renderer::Passes::begin_picture(std::size_t index, const RenderOptions& options) {
  while (pictures.size() <= index) pictures.push_back(std::make_unique<PictureBuffers>());
  picture = pictures[index].get();
  picture->resize(options);
  materials.bind();
}

void Renderer::Passes::upload(const DrawScene& scene, float pixel_scale) {
  surface.upload(scene.surface);
  embedded.upload(scene.embedded);
  materials.upload(scene.embedded.materials);
  spheres.upload(scene.spheres);
  crumbs.upload(scene.crumbs);
  puffs.upload(scene.puffs);
  glyphs.upload(scene.glyphs);
  strokes.upload(scene, pixel_scale);
}

void Renderer::Passes::draw_depths(const DrawScene& scene, const RenderOptions& options,
                                   const HiddenBacks& backs) const {
  if (scene.surface.opacity == 1)
    draw_depths_of_surfaces(has_glass(scene, options) ? DrawnPart::not_clear : DrawnPart::all, backs);
  spheres.draw_shadow();
  crumbs.draw_shadow();
}

void Renderer::Passes::draw_depths_of_surfaces(DrawnPart part, const HiddenBacks& backs) const {
  glEnable(GL_CLIP_DISTANCE0);
  {
    const Culling culling(backs.surface);
    surface.draw_depth(part);
  }
  const Culling culling(backs.embedded);
  embedded.draw_depth(part);
  glDisable(GL_CLIP_DISTANCE0);
}

void Renderer::Passes::draw_shadow_maps(const DrawScene& scene, const ViewBlock& view, const RenderOptions& options,
                                        int texels) {
  const bool clear = has_glass(scene, options);
  const HiddenBacks backs = hidden_backs(scene, clear);
  shadow_map.begin(texels);
  if (options.shadows) {
    shadow_view.bind(view);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glEnable(GL_DEPTH_CLAMP);  // objects between the map and the lamp cast shadows too
    glPolygonOffset(1.5f, 2);  // against self-shadowing
    draw_depths(scene, options, backs);
  }
  if (clear) clear_shadow_map.begin(texels);
  if (clear && options.shadows) draw_depths_of_surfaces(DrawnPart::clear, backs);
  glDisable(GL_POLYGON_OFFSET_FILL);
  glDisable(GL_DEPTH_CLAMP);
}

void Renderer::Passes::draw_ground(const DrawScene& scene, const Camera& camera, const Focus& focus,
                                   Light light) const {
  if (!scene.ground || !scene.ground->drawn) return;
  const bool from_below = camera.position.y() < scene.ground->height;
  ground.draw(*scene.ground, grid_level(height_at_target(camera)), focus.center, ground_radius(focus), from_below,
              light);
}

void Renderer::Passes::draw_occlusion_map(const DrawScene& scene, const Camera& camera, const Focus& focus,
                                          const Mat4& view_projection, const RenderOptions& options) {
  constexpr float kReach = 0.15f;  // [radii of the focus]
  const Effects effects = effects_of(options.quality);
  if (effects.occlusion_samples == 0) return;
  const int width = (picture->target.width() + effects.occlusion_fraction - 1) / effects.occlusion_fraction;
  const int height = (picture->target.height() + effects.occlusion_fraction - 1) / effects.occlusion_fraction;
  if (!picture->occlusion || picture->occlusion->width() != width || picture->occlusion->height() != height)
    picture->occlusion = std::make_unique<OcclusionMap>(width, height);
  picture->occlusion->begin();
  draw_depths(scene, options, hidden);
  draw_ground(scene, camera, focus, Light::plain);
  picture->occlusion->finish(view_projection, kReach * focus.radius, effects.occlusion_samples);
}

void Renderer::Passes::draw_surfaces(const DrawScene& scene, const RenderOptions& options, Output output,
                                     DrawnPart part) const {
  glEnable(GL_CLIP_DISTANCE0);
  {
    const Culling culling(output == Output::opaque && hidden.surface);
    surface.draw(scene.surface, color_tables, options, output, part);
  }
  const Culling culling(output == Output::opaque && hidden.embedded);
  embedded.draw(scene.embedded, scene.surface.scalar_style, color_tables, options, scene.surface.opacity, output, part);
  glDisable(GL_CLIP_DISTANCE0);
}

void Renderer::Passes::draw_picture(const DrawScene& scene, const Camera& camera, const Focus& focus,
                                    const RenderOptions& options) {
  const bool see_through = scene.surface.opacity < 1, clear = has_glass(scene, options);
  picture->target.bind();
  picture->target.clear(scene.background.bottom);
  shadow_map.bind();
  clear_shadow_map.bind_clear();
  background.draw(scene.background, world_from_clip, light_of(options.quality));
  glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);  // the picture is opaque; alpha is used for blending alone
  draw_surfaces(scene, options, Output::opaque, opaque_part(scene, clear));
  spheres.draw(light_of(options.quality));
  crumbs.draw(light_of(options.quality));
  glyphs.draw(Output::opaque);
  draw_ground(scene, camera, focus, light_of(options.quality));
  strokes.draw();
  puffs.draw(light_of(options.quality));
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  if (see_through || clear || glyphs.has_transparent()) {
    draw_transparent(scene, options);
  } else {
    picture->target.resolve();
  }
}

void Renderer::Passes::add_up_glass(const DrawScene& scene, const RenderOptions& options) {
  if (!picture->glass) picture->glass = std::make_unique<GlassTarget>(picture->target);
  picture->glass->begin(world_from_clip);
  draw_surfaces(scene, options, Output::glass, DrawnPart::clear);
  picture->glass->end();
}

void Renderer::Passes::draw_transparent(const DrawScene& scene, const RenderOptions& options) {
  const bool see_through = scene.surface.opacity < 1, clear = has_glass(scene, options);
  if (!picture->blend) picture->blend = std::make_unique<BlendTarget>(picture->target);
  picture->blend->begin();
  if (see_through) draw_surfaces(scene, options, Output::transparent, DrawnPart::unselected);
  glyphs.draw(Output::transparent);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  if (clear) add_up_glass(scene, options);
  if (see_through || clear) {  // transparent objects can be picked
    picture->target.bind();
    glColorMaski(0, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    draw_surfaces(scene, options, Output::opaque, clear ? DrawnPart::clear : DrawnPart::unselected);
    glColorMaski(0, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  picture->target.resolve();
  picture->blend->end();
  if (clear) picture->glass->blend();
}

Renderer::Renderer() : passes_(std::make_unique<Passes>()) {
  passes_->pictures.push_back(std::make_unique<PictureBuffers>());
}
Renderer::~Renderer() = default;

void Renderer::render(const DrawScene& scene, const Camera& camera, const RenderOptions& options) {
  upload(scene, options.pixel_scale);
  draw(scene, camera, options);
}

void Renderer::upload(const DrawScene& scene, float pixel_scale) { passes_->upload(scene, pixel_scale); }

void Renderer::draw(const DrawScene& scene, const Camera& camera, const RenderOptions& options, std::size_t picture) {
  const BoundFramebuffer previous;
  const Eigen::AlignedBox3f box = bounds(scene);
  const Focus focus = focus_of(box, camera);
  const int texels = shadow_texels(focus, camera, options);
  ViewBlock shadow_view = ShadowMap::view(focus, texels);
  shadow_view.visible = visible_plane(scene, focus.radius);
  set_state();
  passes_->begin_picture(picture, options);
  passes_->hidden = hidden_backs_from(scene, has_glass(scene, options), camera.position);
  passes_->draw_shadow_maps(scene, shadow_view, options, texels);
  ViewBlock view = picture_view(camera, visible_box(scene, focus, box), passes_->picture->target, options, shadow_view,
                                effects_of(options.quality));
  view.effects.z() = has_glass(scene, options) ? 1.0f : 0.0f;
  view.effects.w() = scene.environment.kind == Environment::Kind::sky ? 1.0f : 0.0f;
  view.surroundings = surroundings_of(scene);
  passes_->picture_view.bind(view);
  passes_->world_from_clip = view.view_projection.cast<double>().inverse().cast<float>();
  passes_->draw_occlusion_map(scene, camera, focus, view.view_projection, options);
  passes_->draw_picture(scene, camera, focus, options);
}

unsigned Renderer::color_texture(std::size_t picture) const {
  return passes_->pictures.at(picture)->target.color_texture();
}

Image Renderer::image(std::size_t picture) const { return passes_->pictures.at(picture)->target.image(); }

IdImage Renderer::ids() const { return passes_->pictures.front()->target.ids(); }

std::int32_t Renderer::id_at(int x, int y, std::size_t picture) const {
  return passes_->pictures.at(picture)->target.id_at(x, y);
}

}  // namespace griffith::render
