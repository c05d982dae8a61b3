#include "renderer/blend_target.h"

#include "renderer/error.h"
#include "renderer/shaders.h"

namespace griffith::render {
namespace {

constexpr GLenum kColorSums = GL_COLOR_ATTACHMENT0, kWeightSums = GL_COLOR_ATTACHMENT1;

void attach_texture(const Texture& texture, GLenum attachment, GLint format, GLenum layout, const Target& target) {
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, format, target.width(), target.height(), 0, layout, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.id(), 0);
}

void attach_samples(const Renderbuffer& buffer, GLenum attachment, GLenum format, const Target& target) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, target.samples(), format, target.width(), target.height());
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.id());
}

void attach_depth(const Target& target) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth_buffer());
}

void finish() {
  const GLenum buffers[] = {kColorSums, kWeightSums};
  glDrawBuffers(2, buffers);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw RenderError("the graphics device can't blend into 16-bit floating point images");
}

}  // namespace

BlendTarget::BlendTarget(const Target& target)
    : target_(target),
      program_("blend", shaders::background_vert, shaders::blend_frag),
      sample_color_sums_(target.samples() > 1 ? Renderbuffer() : Renderbuffer(nullptr)),
      sample_weight_sums_(target.samples() > 1 ? Renderbuffer() : Renderbuffer(nullptr)),
      multisampled_(target.samples() > 1 ? Framebuffer() : Framebuffer(nullptr)) {
  const BoundFramebuffer previous;
  make_buffers();
}

void BlendTarget::make_buffers() {
  glActiveTexture(GL_TEXTURE0 + kColorSumsUnit);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
  attach_texture(color_sums_, kColorSums, GL_RGBA16F, GL_RGBA, target_);
  attach_texture(weight_sums_, kWeightSums, GL_R16F, GL_RED, target_);
  if (target_.samples() > 1) {
    finish();
    glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.id());
    attach_samples(sample_color_sums_, kColorSums, GL_RGBA16F, target_);
    attach_samples(sample_weight_sums_, kWeightSums, GL_R16F, target_);
  }
  attach_depth(target_);
  finish();
}

void BlendTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, target_.samples() > 1 ? multisampled_.id() : resolved_.id());
  const GLfloat nothing[] = {0, 0, 0, 1};
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_COLOR, 1, nothing);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
}

void BlendTarget::end() const {
  if (target_.samples() > 1) resolve_attachments(multisampled_, resolved_, target_.width(), target_.height());
  glBindFramebuffer(GL_FRAMEBUFFER, target_.resolved_framebuffer());
  glActiveTexture(GL_TEXTURE0 + kColorSumsUnit);
  glBindTexture(GL_TEXTURE_2D, color_sums_.id());
  glActiveTexture(GL_TEXTURE0 + kWeightSumsUnit);
  glBindTexture(GL_TEXTURE_2D, weight_sums_.id());
  program_.use();
  glBindVertexArray(vertices_.id());
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_ONE_MINUS_SRC_ALPHA, GL_SRC_ALPHA, GL_ZERO, GL_ONE);
  glDisable(GL_DEPTH_TEST);
  glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
}

}  // namespace griffith::render
