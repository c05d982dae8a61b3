#include "renderer/shadow_map.h"

#include <Eigen/Geometry>

#include "renderer/shader_program.h"

namespace griffith::render {

ShadowMap::ShadowMap() {
  glSamplerParameteri(depth_values_.id(), GL_TEXTURE_COMPARE_MODE, GL_NONE);
  glSamplerParameteri(depth_values_.id(), GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glSamplerParameteri(depth_values_.id(), GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glSamplerParameteri(depth_values_.id(), GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glSamplerParameteri(depth_values_.id(), GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  resize(kMostTexels);
  const GLfloat lit[] = {1, 1, 1, 1};  // outside of the map
  glTexParameterfv(GL_TEXTURE_2D, GL_TEXTURE_BORDER_COLOR, lit);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_BORDER);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  const BoundFramebuffer previous;
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
}

void ShadowMap::resize(int texels) {
  texels_ = texels;
  glActiveTexture(GL_TEXTURE0 + kShadowUnit);
  glBindTexture(GL_TEXTURE_2D, depth_.id());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT24, texels, texels, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_INT, nullptr);
}

void ShadowMap::begin(int texels) {
  const GLfloat depth = 1;
  if (texels != texels_) resize(texels);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
  glViewport(0, 0, texels, texels);
  glClearBufferfv(GL_DEPTH, 0, &depth);
}

void ShadowMap::bind() const {
  for (const int unit : {kShadowUnit, kShadowDepthUnit}) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, depth_.id());
  }
  glBindSampler(kShadowDepthUnit, depth_values_.id());
}

void ShadowMap::bind_clear() const {
  glActiveTexture(GL_TEXTURE0 + kClearShadowUnit);
  glBindTexture(GL_TEXTURE_2D, depth_.id());
}

ViewBlock ShadowMap::view(const Focus& focus, int texels) {
  const Eigen::Vector3f light = Eigen::Vector3f(-0.55f, 0.78f, 0.55f).normalized();
  const Eigen::Vector3f right = Eigen::Vector3f::UnitY().cross(light).normalized();
  Eigen::Matrix3f axes;
  axes << right.transpose(), light.cross(right).transpose(), -light.transpose();
  ViewBlock block;
  block.view_projection.topLeftCorner<3, 3>() = axes / focus.radius;
  block.view_projection.topRightCorner<3, 1>() = -axes * focus.center / focus.radius;
  Mat4 to_unit_cube = Vec4(0.5f, 0.5f, 0.5f, 1).asDiagonal();
  to_unit_cube.topRightCorner<3, 1>().setConstant(0.5f);
  block.shadow_matrix = to_unit_cube * block.view_projection;
  block.eye << light, 0;
  const auto side = static_cast<float>(texels);
  block.light << light, 2 * focus.radius / side;
  block.viewport = Vec4(side, side, 1, 0);
  return block;
}

}  // namespace griffith::render
