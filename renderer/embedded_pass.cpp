#include "renderer/embedded_pass.h"

#include <algorithm>
#include <string>

#include "renderer/shaders.h"

namespace griffith::render {
namespace {

static_assert(sizeof(EmbeddedCorner) == 21 * sizeof(float), "uploaded as it is");

const void* offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

/// Describes the attributes of corners in the bound buffer.
void describe_corners() {
  const auto floats = [](GLuint index, GLint size, std::size_t at) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, size, GL_FLOAT, GL_FALSE, sizeof(EmbeddedCorner), offset(at));
  };
  floats(0, 3, offsetof(EmbeddedCorner, rest));
  floats(1, 4, offsetof(EmbeddedCorner, weights));
  floats(2, 4, offsetof(EmbeddedCorner, other_weights));
  glEnableVertexAttribArray(3);
  glVertexAttribIPointer(3, 4, GL_INT, sizeof(EmbeddedCorner), offset(offsetof(EmbeddedCorner, tet)));
  const auto shorts = [](GLuint index, std::size_t at) {
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, 4, GL_SHORT, GL_TRUE, sizeof(EmbeddedCorner), offset(at));
  };
  shorts(4, offsetof(EmbeddedCorner, normal));
  shorts(5, offsetof(EmbeddedCorner, other_normal));
  floats(6, 2, offsetof(EmbeddedCorner, uv));
}

void add_fan(std::vector<std::uint32_t>& indices, const EmbeddedPolygon& polygon) {
  const auto first = static_cast<std::uint32_t>(polygon.first_corner);
  const auto corners = static_cast<std::uint32_t>(polygon.corners);
  for (std::uint32_t i = 2; i < corners; ++i) indices.insert(indices.end(), {first, first + i - 1, first + i});
}

/// Returns 0 for none, 1 for one scalar per tet, 2 for one per point.
int scalar_kind(const EmbeddedSurface& surface) {
  if (surface.scalars.empty()) return 0;
  return surface.scalars_per_point ? 2 : 1;
}

std::string embedded_fragment(Output output) {
  return with_output(
      std::string(shaders::shading_glsl) + shaders::grain_glsl + shaders::matter_glsl + shaders::embedded_frag, output);
}

/// True if materials show their grain.
bool shows_grain(const EmbeddedSurface& surface, const RenderOptions& options, Output output) {
  return output == Output::opaque && options.quality != Quality::draft && surface.scalars.empty() &&
         surface.piece_colors.empty() &&
         std::ranges::any_of(surface.materials, [](const auto& material) { return material.grain != Grain::none; });
}

/// True if a draft shows only materials.
bool is_plain(const EmbeddedSurface& surface, const RenderOptions& options) {
  return options.quality == Quality::draft && surface.scalars.empty() && surface.piece_colors.empty() &&
         !options.edges && !surface.checker;
}

}  // namespace

EmbeddedPass::EmbeddedPass()
    : program_("embedded surface", shaders::embedded_vert, embedded_fragment(Output::opaque)),
      transparent_program_("transparent embedded surface", shaders::embedded_vert,
                           embedded_fragment(Output::transparent)),
      plain_program_("plain embedded surface", shaders::embedded_vert,
                     ("#define NATURAL\n" + embedded_fragment(Output::opaque)).c_str(), Light::plain),
      glass_program_("clear embedded surface", shaders::embedded_vert, embedded_fragment(Output::glass).c_str()),
      grain_program_("broken embedded surface", shaders::embedded_vert,
                     ("#define GRAIN\n" + embedded_fragment(Output::opaque)).c_str()),
      depth_program_("embedded depth", shaders::embedded_vert, shaders::depth_frag) {
  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, triangles_.id());
  describe_corners();
}

void EmbeddedPass::upload(const EmbeddedSurface& surface) {
  if (mesh_ != surface.mesh) {
    mesh_ = surface.mesh;
    upload_mesh();
  }
  if (!mesh_) return;
  upload_opened(surface.opened);
  points_.upload(surface.points, 3);
  tets_.upload(surface.tets, 4);
  carriers_.upload(surface.carriers);
  scalars_.upload(surface.scalars);
  colors_.upload(surface.piece_colors, 3);
}

void EmbeddedPass::upload_mesh() {
  indices_ = outer_indices_ = 0;
  opened_.clear();
  if (!mesh_) return;
  glBindBuffer(GL_ARRAY_BUFFER, corners_.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(mesh_->corners.size() * sizeof(EmbeddedCorner)),
               mesh_->corners.data(), GL_STATIC_DRAW);
  std::size_t indices = 0;
  for (const EmbeddedPolygon& polygon : mesh_->polygons) indices += 3 * static_cast<std::size_t>(polygon.corners - 2);
  glBindVertexArray(vertices_.id());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(indices * sizeof(std::uint32_t)), nullptr,
               GL_DYNAMIC_DRAW);
  append_triangles(mesh_->outer);
  outer_indices_ = indices_;
}

void EmbeddedPass::append_triangles(std::span<const std::int32_t> polygons) {
  std::vector<std::uint32_t> indices;
  for (const std::int32_t polygon : polygons) add_fan(indices, mesh_->polygons[static_cast<std::size_t>(polygon)]);
  glBindVertexArray(vertices_.id());
  glBufferSubData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLintptr>(indices_) * GLintptr{sizeof(std::uint32_t)},
                  static_cast<GLsizeiptr>(indices.size() * sizeof(std::uint32_t)), indices.data());
  indices_ += static_cast<GLsizei>(indices.size());
}

void EmbeddedPass::upload_opened(const std::vector<std::int32_t>& opened) {
  const bool grew = opened.size() >= opened_.size() && std::equal(opened_.begin(), opened_.end(), opened.begin());
  if (!grew) {
    indices_ = outer_indices_;
    opened_.clear();
  }
  if (opened.size() == opened_.size()) return;
  append_triangles(std::span(opened).subspan(opened_.size()));
  opened_ = opened;
}

void EmbeddedPass::draw_depth(DrawnPart part) const {
  if (!mesh_) return;
  depth_program_.use();
  depth_program_.set("drawn_part", static_cast<int>(part));
  depth_program_.set("selected_tet", -1);  // what is transparent throws the same shadow when it is selected
  depth_program_.set("scalar_kind", 0);
  draw_triangles(0, indices_);
}

void EmbeddedPass::draw(const EmbeddedSurface& surface, const ScalarStyle& style, const ColorTables& color_tables,
                        const RenderOptions& options, float opacity, Output output, DrawnPart part) const {
  if (!mesh_) return;
  color_tables.bind(style.color_map);
  const auto use = [&](const ShaderProgram& program) {
    program.use();
    program.set("scalar_kind", scalar_kind(surface));
    program.set("scalar_range", style.minimum, style.maximum);
    program.set("has_piece_colors", !surface.piece_colors.empty());
    program.set("nan_color", kNanColor);
    program.set("draw_edges", options.edges);
    program.set("edge_width", options.edge_width * options.pixel_scale);
    program.set("unlit", options.unlit_scalars);
    program.set("selected_tet", surface.selected_tet);
    program.set("opacity", opacity);
    program.set("drawn_part", static_cast<int>(part));
    program.set("checker", surface.checker);
  };
  const bool dressed = std::ranges::any_of(surface.materials, &EmbeddedMaterial::dressed);
  const GLsizei plain = !shows_grain(surface, options, output) ? indices_ : dressed ? 0 : outer_indices_;
  use(program_for(surface, options, output, part));
  draw_triangles(0, plain);
  if (plain == indices_) return;
  use(grain_program_);
  draw_triangles(plain, indices_);
}

const ShaderProgram& EmbeddedPass::program_for(const EmbeddedSurface& surface, const RenderOptions& options,
                                               Output output, DrawnPart part) const {
  if (output == Output::glass) return glass_program_;
  if (output == Output::transparent) return transparent_program_.in(light_of(options.quality));
  const bool plain = part == DrawnPart::all && is_plain(surface, options);
  return plain ? plain_program_ : program_.in(light_of(options.quality));
}

void EmbeddedPass::draw_triangles(GLsizei first, GLsizei end) const {
  points_.bind(kPointsUnit);
  tets_.bind(kTetsUnit);
  carriers_.bind(kCarriersUnit);
  scalars_.bind(kScalarsUnit);
  colors_.bind(kColorsUnit);
  glBindVertexArray(vertices_.id());
  glDrawElements(GL_TRIANGLES, end - first, GL_UNSIGNED_INT,
                 offset(static_cast<std::size_t>(first) * sizeof(std::uint32_t)));
}

}  // namespace griffith::render
