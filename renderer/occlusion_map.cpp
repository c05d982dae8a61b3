#include "renderer/occlusion_map.h"

#include <Eigen/LU>

#include "renderer/error.h"
#include "renderer/shaders.h"

namespace griffith::render {
namespace {

void check_occlusion_buffer() {
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw RenderError("the graphics device can't draw into 16-bit floating point images of two channels");
}

void bind_map(const Texture& texture) {
  glActiveTexture(GL_TEXTURE0 + kOcclusionUnit);
  glBindTexture(GL_TEXTURE_2D, texture.id());
}

void make_map(const Texture& texture, const Framebuffer& buffer, GLenum attachment, GLint format, GLenum layout,
              int width, int height) {
  bind_map(texture);
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, layout, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, buffer.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.id(), 0);
  const GLenum drawn = attachment == GL_DEPTH_ATTACHMENT ? GL_NONE : attachment;
  glDrawBuffers(1, &drawn);
  glReadBuffer(drawn);
  check_occlusion_buffer();
}

}  // namespace

OcclusionMap::OcclusionMap(int width, int height)
    : width_(width),
      height_(height),
      occlusion_("occlusion", shaders::background_vert, shaders::occlusion_frag),
      blur_("occlusion blur", shaders::background_vert, shaders::occlusion_blur_frag) {
  const BoundFramebuffer previous;
  make_map(depth_, depth_buffer_, GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, width, height);
  make_map(raw_, raw_buffer_, GL_COLOR_ATTACHMENT0, GL_RG16F, GL_RG, width, height);
  make_map(blurred_, blurred_buffer_, GL_COLOR_ATTACHMENT0, GL_RG16F, GL_RG, width, height);
}

void OcclusionMap::begin() const {
  const GLfloat depth = 1;
  glBindFramebuffer(GL_FRAMEBUFFER, depth_buffer_.id());
  glViewport(0, 0, width_, height_);
  glClearBufferfv(GL_DEPTH, 0, &depth);
}

void OcclusionMap::finish(const Mat4& view_projection, float reach, int samples) const {
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(vertices_.id());
  glBindFramebuffer(GL_FRAMEBUFFER, raw_buffer_.id());
  bind_map(depth_);
  occlusion_.use();
  occlusion_.set("world_from_clip", Mat4(view_projection.cast<double>().inverse().cast<float>()));
  occlusion_.set("reach", reach);
  occlusion_.set("samples", samples);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindFramebuffer(GL_FRAMEBUFFER, blurred_buffer_.id());
  bind_map(raw_);
  blur_.use();
  glDrawArrays(GL_TRIANGLES, 0, 3);
  bind_map(blurred_);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace griffith::render
