#include "renderer/glass_target.h"

#include "renderer/error.h"
#include "renderer/shaders.h"

namespace griffith::render {
namespace {

struct GlassSum {
  GLenum attachment;
  int unit;
  GLint format;
  GLenum layout;
};

// Differences of distances matter: 16 bits would be too few for the depths.
constexpr std::array<GlassSum, 3> kGlassSums = {{{GL_COLOR_ATTACHMENT0, kColorSumsUnit, GL_RGBA32F, GL_RGBA},
                                                 {GL_COLOR_ATTACHMENT1, kWeightSumsUnit, GL_RGBA16F, GL_RGBA},
                                                 {GL_COLOR_ATTACHMENT2, kFaceSumsUnit, GL_RGBA16F, GL_RGBA}}};

void draw_into_all_sums() {
  constexpr GLenum kBuffers[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
  glDrawBuffers(3, kBuffers);
}

void finish_glass_buffer(const Target& target) {
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, target.depth_buffer());
  draw_into_all_sums();
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw RenderError("the graphics device can't blend into 32-bit floating point images");
}

void bind_texture(int unit, const Texture& texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture.id());
}

void make_glass_texture(const Texture& texture, int unit, GLint format, GLenum layout, GLint filter,
                        const Target& target) {
  bind_texture(unit, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, format, target.width(), target.height(), 0, layout, GL_FLOAT, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

}  // namespace

GlassTarget::GlassTarget(const Target& target)
    : target_(target),
      program_("glass", shaders::background_vert, shaders::glass_blend_frag),
      distance_program_("distance of opaque objects", shaders::background_vert, shaders::glass_distance_frag) {
  const BoundFramebuffer previous;
  make_buffers();
  make_distance_buffers();
}

void GlassTarget::make_buffers() {
  make_glass_texture(opaque_, kOpaqueUnit, GL_RGBA8, GL_RGBA, GL_LINEAR, target_);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
  for (std::size_t i = 0; i < kSums; ++i) {
    const GlassSum& sum = kGlassSums[i];
    make_glass_texture(sums_[i], sum.unit, sum.format, sum.layout, GL_NEAREST, target_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, sum.attachment, GL_TEXTURE_2D, sums_[i].id(), 0);
  }
  if (target_.samples() == 1) return finish_glass_buffer(target_);
  draw_into_all_sums();
  glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.id());
  for (std::size_t i = 0; i < kSums; ++i) {
    const GlassSum& sum = kGlassSums[i];
    glBindRenderbuffer(GL_RENDERBUFFER, samples_[i].id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, target_.samples(), static_cast<GLenum>(sum.format),
                                     target_.width(), target_.height());
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, sum.attachment, GL_RENDERBUFFER, samples_[i].id());
  }
  finish_glass_buffer(target_);
}

void GlassTarget::make_distance_buffers() {
  make_glass_texture(depth_, kOpaqueDistanceUnit, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT, GL_NEAREST, target_);
  glBindFramebuffer(GL_FRAMEBUFFER, depth_buffer_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
  glDrawBuffer(GL_NONE);
  glReadBuffer(GL_NONE);
  make_glass_texture(distances_, kOpaqueDistanceUnit, GL_R32F, GL_RED, GL_NEAREST, target_);
  glBindFramebuffer(GL_FRAMEBUFFER, distance_buffer_.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, distances_.id(), 0);
}

/// Leaves the depth test disabled.
void GlassTarget::measure_distances(const Mat4& world_from_clip) const {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, target_.samples() > 1 ? multisampled_.id() : resolved_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, depth_buffer_.id());
  glBlitFramebuffer(0, 0, target_.width(), target_.height(), 0, 0, target_.width(), target_.height(),
                    GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_FRAMEBUFFER, distance_buffer_.id());
  bind_texture(kOpaqueDistanceUnit, depth_);
  distance_program_.use();
  distance_program_.set("world_from_clip", world_from_clip);
  glBindVertexArray(vertices_.id());
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  bind_texture(kOpaqueDistanceUnit, distances_);
}

void GlassTarget::begin(const Mat4& world_from_clip) const {
  measure_distances(world_from_clip);
  glBindFramebuffer(GL_FRAMEBUFFER, target_.samples() > 1 ? multisampled_.id() : resolved_.id());
  const GLfloat nothing[] = {0, 0, 0, 0};
  for (GLint i = 0; i < static_cast<GLint>(kSums); ++i) glClearBufferfv(GL_COLOR, i, nothing);
  glDepthMask(GL_FALSE);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
}

void GlassTarget::end() const {
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glEnable(GL_DEPTH_TEST);
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
}

void GlassTarget::resolve() const {
  if (target_.samples() == 1) return;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled_.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_.id());
  for (std::size_t i = 0; i < kSums; ++i) {
    GLenum buffers[kSums] = {GL_NONE, GL_NONE, GL_NONE};
    buffers[i] = kGlassSums[i].attachment;
    glReadBuffer(buffers[i]);
    glDrawBuffers(static_cast<GLsizei>(kSums), buffers);
    glBlitFramebuffer(0, 0, target_.width(), target_.height(), 0, 0, target_.width(), target_.height(),
                      GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  draw_into_all_sums();
}

void GlassTarget::blend() const {
  resolve();
  glBindFramebuffer(GL_FRAMEBUFFER, target_.resolved_framebuffer());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  bind_texture(kOpaqueUnit, opaque_);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, target_.width(), target_.height());
  for (std::size_t i = 0; i < kSums; ++i) bind_texture(kGlassSums[i].unit, sums_[i]);
  program_.use();
  glBindVertexArray(vertices_.id());
  glDisable(GL_DEPTH_TEST);
  glColorMaski(1, GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColorMaski(1, GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST);
}

}  // namespace griffith::render
