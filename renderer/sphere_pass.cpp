#include "renderer/sphere_pass.h"

#include <string>
#include <type_traits>

#include "renderer/shaders.h"
#include "renderer/vertex_attribute.h"

namespace griffith::render {

static_assert(std::is_standard_layout_v<Sphere>, "uploaded as it is");

namespace {

std::string shape_source(SpherePass::Shape shape, const char* ball, const char* chip) {
  return shape == SpherePass::Shape::ball ? std::string(shaders::grain_glsl) + ball
                                          : std::string(shaders::chip_glsl) + chip;
}

}  // namespace

SpherePass::SpherePass(Shape shape)
    : program_("sphere", shaders::sphere_vert, shape_source(shape, shaders::sphere_frag, shaders::chip_frag)),
      shadow_program_("sphere shadow", shaders::sphere_vert,
                      shape_source(shape, shaders::sphere_depth_frag, shaders::chip_depth_frag).c_str()) {
  glBindVertexArray(vertices_.id());
  glBindBuffer(GL_ARRAY_BUFFER, spheres_.id());
  instance_floats(0, 3, sizeof(Sphere), offsetof(Sphere, center));
  instance_floats(1, 1, sizeof(Sphere), offsetof(Sphere, radius));
  instance_floats(2, 3, sizeof(Sphere), offsetof(Sphere, color));
  instance_integer(3, sizeof(Sphere), offsetof(Sphere, id));
  instance_floats(4, 3, sizeof(Sphere), offsetof(Sphere, metal));
  instance_floats(5, 4, sizeof(Sphere), offsetof(Sphere, rotation));
}

void SpherePass::upload(const std::vector<Sphere>& spheres) {
  count_ = static_cast<GLsizei>(spheres.size());
  spheres_.upload(spheres);
}

void SpherePass::draw_shadow() const {
  shadow_program_.use();
  draw_squares();
}

void SpherePass::draw(Light light) const {
  program_.in(light).use();
  glEnable(GL_SAMPLE_ALPHA_TO_COVERAGE);  // smooth outlines; no effect with one sample
  draw_squares();
  glDisable(GL_SAMPLE_ALPHA_TO_COVERAGE);
}

void SpherePass::draw_squares() const {
  glBindVertexArray(vertices_.id());
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count_);
}

}  // namespace griffith::render
