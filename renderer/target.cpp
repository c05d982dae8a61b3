#include "renderer/target.h"

#include <algorithm>
#include <cassert>
#include <string>

#include "renderer/draw_scene.h"
#include "renderer/error.h"

namespace griffith::render {
namespace {

constexpr GLenum kColorAttachment = GL_COLOR_ATTACHMENT0, kIdAttachment = GL_COLOR_ATTACHMENT1;

int supported_samples(int requested) {
  GLint maximum = 1;
  for (const GLenum limit : {GL_MAX_SAMPLES, GL_MAX_INTEGER_SAMPLES}) {
    GLint samples = 1;
    glGetIntegerv(limit, &samples);
    maximum = limit == GL_MAX_SAMPLES ? samples : std::min(maximum, samples);
  }
  return std::clamp(requested, 1, std::max(maximum, 1));
}

void make_texture(const Texture& texture, GLint format, GLenum layout, GLenum type, int width, int height,
                  GLenum attachment) {
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, format, width, height, 0, layout, type, nullptr);
  const GLint filter = layout == GL_RGBA ? GL_LINEAR : GL_NEAREST;
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, filter);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.id(), 0);
}

/// `samples` 0: an ordinary, single-sampled buffer.
void make_renderbuffer(const Renderbuffer& buffer, int samples, GLenum format, int width, int height,
                       GLenum attachment) {
  glBindRenderbuffer(GL_RENDERBUFFER, buffer.id());
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer.id());
}

void finish_framebuffer(int width, int height) {
  const GLenum buffers[] = {kColorAttachment, kIdAttachment};
  glDrawBuffers(2, buffers);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    throw RenderError("the graphics device can't draw into an image of " + std::to_string(width) + "x" +
                      std::to_string(height) + " pixels");
  }
}

/// Reverses the rows: OpenGL counts them from below. `row`: values per row.
template <class Value>
void turn_upside_down(std::vector<Value>& values, std::size_t row) {
  for (auto top = values.begin(), end = values.end(); end - top > static_cast<std::ptrdiff_t>(row);) {
    end -= static_cast<std::ptrdiff_t>(row);
    std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), end);
    top += static_cast<std::ptrdiff_t>(row);
  }
}

}  // namespace

Target::Target(int width, int height, int samples)
    : width_(width),
      height_(height),
      samples_(supported_samples(samples)),
      sample_color_(samples_ > 1 ? Renderbuffer() : Renderbuffer(nullptr)),
      sample_ids_(samples_ > 1 ? Renderbuffer() : Renderbuffer(nullptr)),
      multisampled_(samples_ > 1 ? Framebuffer() : Framebuffer(nullptr)) {
  assert(width > 0 && height > 0);
  const BoundFramebuffer previous;
  glActiveTexture(GL_TEXTURE0);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_.id());
  make_texture(color_, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, width, height, kColorAttachment);
  make_texture(ids_, GL_R32I, GL_RED_INTEGER, GL_INT, width, height, kIdAttachment);
  if (samples_ > 1) {
    finish_framebuffer(width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, multisampled_.id());
    make_renderbuffer(sample_color_, samples_, GL_RGBA8, width, height, kColorAttachment);
    make_renderbuffer(sample_ids_, samples_, GL_R32I, width, height, kIdAttachment);
  }
  make_renderbuffer(depth_, samples_ > 1 ? samples_ : 0, GL_DEPTH_COMPONENT24, width, height, GL_DEPTH_ATTACHMENT);
  finish_framebuffer(width, height);
}

void Target::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, samples_ > 1 ? multisampled_.id() : resolved_.id());
  glViewport(0, 0, width_, height_);
}

void Target::clear(const Rgb& color) const {
  const GLfloat rgba[] = {color.r, color.g, color.b, 1};
  const GLfloat depth = 1;
  const GLint id = kNoId;
  glClearBufferfv(GL_COLOR, 0, rgba);
  glClearBufferiv(GL_COLOR, 1, &id);
  glClearBufferfv(GL_DEPTH, 0, &depth);
}

void Target::resolve() const {
  if (samples_ == 1) return;
  const BoundFramebuffer previous;
  resolve_attachments(multisampled_, resolved_, width_, height_);
}

Image Target::image() const {
  const BoundFramebuffer previous;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  glReadBuffer(kColorAttachment);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  const std::size_t row = 4 * static_cast<std::size_t>(width_);
  Image image{width_, height_, std::vector<std::uint8_t>(row * height_)};
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  turn_upside_down(image.rgba, row);
  return image;
}

IdImage Target::ids() const {
  const BoundFramebuffer previous;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  glReadBuffer(kIdAttachment);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  const std::size_t row = static_cast<std::size_t>(width_);
  IdImage image{width_, height_, std::vector<std::int32_t>(row * height_)};
  glReadPixels(0, 0, width_, height_, GL_RED_INTEGER, GL_INT, image.ids.data());
  turn_upside_down(image.ids, row);
  return image;
}

std::int32_t Target::id_at(int x, int y) const {
  if (x < 0 || y < 0 || x >= width_ || y >= height_) return kNoId;
  const BoundFramebuffer previous;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_.id());
  glReadBuffer(kIdAttachment);
  GLint id = kNoId;
  glReadPixels(x, height_ - 1 - y, 1, 1, GL_RED_INTEGER, GL_INT, &id);
  return id;
}

}  // namespace griffith::render
