#include "renderer/surface_pass.h"

#include <cassert>
#include <string>

#include "renderer/shaders.h"

namespace griffith::render {
namespace {

/// Returns 0, 1 or 3.
int scalars_per_triangle(const Surface& surface) {
  const std::size_t triangles = surface.positions.size() / 3;
  return triangles == 0 ? 0 : static_cast<int>(surface.scalars.size() / triangles);
}

void check_sizes([[maybe_unused]] const Surface& surface) {
  [[maybe_unused]] const std::size_t triangles = surface.positions.size() / 3;
  assert(surface.positions.size() == 3 * triangles);
  assert(surface.scalars.empty() || surface.scalars.size() == triangles || surface.scalars.size() == 3 * triangles);
  assert(surface.colors.empty() || surface.colors.size() == triangles);
  assert(surface.ids.empty() || surface.ids.size() == triangles);
  assert(surface.matters.empty() || surface.matters.size() == triangles);
  assert(surface.rests.size() == 3 * surface.matters.size());
  assert(surface.flags.empty() || surface.flags.size() == triangles);
}

std::string surface_fragment(Output output) {
  return with_output(
      std::string(shaders::shading_glsl) + shaders::grain_glsl + shaders::matter_glsl + shaders::surface_frag, output);
}

/// True if a draft shows only colors.
bool is_plain(const Surface& surface, const RenderOptions& options) {
  return options.quality == Quality::draft && surface.scalars.empty() && !options.edges;
}

}  // namespace

SurfacePass::SurfacePass()
    : program_("surface", shaders::surface_vert, surface_fragment(Output::opaque)),
      transparent_program_("transparent surface", shaders::surface_vert, surface_fragment(Output::transparent)),
      plain_program_("plain surface", shaders::surface_vert,
                     ("#define NATURAL\n" + surface_fragment(Output::opaque)).c_str(), Light::plain),
      glass_program_("clear surface", shaders::surface_vert, surface_fragment(Output::glass).c_str()),
      grain_program_("surface with grain", shaders::surface_vert,
                     ("#define GRAIN\n" + surface_fragment(Output::opaque)).c_str()),
      depth_program_("surface depth", shaders::surface_vert, shaders::depth_frag),
      part_depth_program_("depth of part of a surface", shaders::surface_vert, shaders::surface_depth_frag) {
  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, positions_.id());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector3f), nullptr);
  glBindBuffer(GL_ARRAY_BUFFER, rests_.id());
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(Eigen::Vector3f), nullptr);
}

void SurfacePass::upload(const Surface& surface) {
  check_sizes(surface);
  corners_ = static_cast<GLsizei>(surface.positions.size());
  positions_.upload(surface.positions);
  scalars_.upload(surface.scalars);
  colors_.upload(surface.colors, 3);
  ids_.upload(surface.ids);
  flags_.upload(surface.flags);
  has_flags_ = !surface.flags.empty();
  has_matters_ = !surface.matters.empty();
  glBindVertexArray(vertices_.id());
  has_matters_ ? glEnableVertexAttribArray(1) : glDisableVertexAttribArray(1);
  if (!has_matters_) return;
  rests_.upload(surface.rests);
  matters_.upload(surface.matters);
}

void SurfacePass::draw_depth(DrawnPart part) const {
  if (part == DrawnPart::clear && !has_flags_) return;
  const ShaderProgram& program = part == DrawnPart::all || !has_flags_ ? depth_program_ : part_depth_program_;
  program.use();
  program.set("scalars_per_triangle", 0);
  program.set("drawn_part", static_cast<int>(part));
  draw_triangles();
}

void SurfacePass::draw(const Surface& surface, const ColorTables& color_tables, const RenderOptions& options,
                       Output output, DrawnPart part) const {
  const ScalarStyle& style = surface.scalar_style;
  const ShaderProgram& program = program_for(surface, options, output, part);
  program.use();
  program.set("scalars_per_triangle", scalars_per_triangle(surface));
  program.set("scalar_range", style.minimum, style.maximum);
  program.set("has_colors", !surface.colors.empty());
  program.set("has_ids", !surface.ids.empty());
  program.set("has_flags", !surface.flags.empty());
  program.set("has_matters", !surface.matters.empty());
  program.set("plain_color", surface.color);
  program.set("nan_color", kNanColor);
  program.set("draw_edges", options.edges);
  program.set("edge_width", options.edge_width * options.pixel_scale);
  program.set("unlit", options.unlit_scalars);
  program.set("opacity", surface.opacity);
  program.set("clear_depth", surface.clear_depth);
  program.set("drawn_part", static_cast<int>(part));
  color_tables.bind(style.color_map);
  draw_triangles();
}

const ShaderProgram& SurfacePass::program_for(const Surface& surface, const RenderOptions& options, Output output,
                                              DrawnPart part) const {
  if (output == Output::glass) return glass_program_;
  if (output == Output::transparent) return transparent_program_.in(light_of(options.quality));
  const bool grain = !surface.matters.empty() && surface.scalars.empty();
  if (grain && options.quality != Quality::draft) return grain_program_;
  const bool plain = part == DrawnPart::all && is_plain(surface, options);
  return plain ? plain_program_ : program_.in(light_of(options.quality));
}

void SurfacePass::draw_triangles() const {
  scalars_.bind(kScalarsUnit);
  colors_.bind(kColorsUnit);
  ids_.bind(kIdsUnit);
  flags_.bind(kFlagsUnit);
  if (has_matters_) matters_.bind(kMattersUnit);
  glBindVertexArray(vertices_.id());
  glDrawArrays(GL_TRIANGLES, 0, corners_);
}

}  // namespace griffith::render
