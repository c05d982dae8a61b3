#pragma once

#include <epoxy/gl.h>

#include <utility>

namespace griffith::render {

/// Owner of one OpenGL object. A null object (made by GlObject(nullptr)) has id 0. Needs a current context from
/// construction to destruction.
template <class Kind>
class GlObject {
 public:
  GlObject() { Kind::create(&id_); }
  explicit GlObject(std::nullptr_t) {}
  ~GlObject() {
    if (id_ != 0) Kind::destroy(&id_);
  }
  GlObject(GlObject&& other) noexcept : id_(std::exchange(other.id_, 0)) {}
  GlObject& operator=(GlObject&& other) noexcept {
    std::swap(id_, other.id_);
    return *this;
  }

  GLuint id() const { return id_; }

 private:
  GLuint id_ = 0;
};

struct TextureKind {
  static void create(GLuint* id) { glGenTextures(1, id); }
  static void destroy(GLuint* id) { glDeleteTextures(1, id); }
};
struct SamplerKind {
  static void create(GLuint* id) { glGenSamplers(1, id); }
  static void destroy(GLuint* id) { glDeleteSamplers(1, id); }
};
struct BufferKind {
  static void create(GLuint* id) { glGenBuffers(1, id); }
  static void destroy(GLuint* id) { glDeleteBuffers(1, id); }
};
struct FramebufferKind {
  static void create(GLuint* id) { glGenFramebuffers(1, id); }
  static void destroy(GLuint* id) { glDeleteFramebuffers(1, id); }
};
struct RenderbufferKind {
  static void create(GLuint* id) { glGenRenderbuffers(1, id); }
  static void destroy(GLuint* id) { glDeleteRenderbuffers(1, id); }
};
struct VertexArrayKind {
  static void create(GLuint* id) { glGenVertexArrays(1, id); }
  static void destroy(GLuint* id) { glDeleteVertexArrays(1, id); }
};
struct ProgramKind {
  static void create(GLuint* id) { *id = glCreateProgram(); }
  static void destroy(GLuint* id) { glDeleteProgram(*id); }
};

using Texture = GlObject<TextureKind>;
using Sampler = GlObject<SamplerKind>;
using Buffer = GlObject<BufferKind>;
using Framebuffer = GlObject<FramebufferKind>;
using Renderbuffer = GlObject<RenderbufferKind>;
using VertexArray = GlObject<VertexArrayKind>;
using Program = GlObject<ProgramKind>;

/// Restores the bound framebuffers and the viewport in its destructor.
class BoundFramebuffer {
 public:
  BoundFramebuffer() {
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &draw_);
    glGetIntegerv(GL_READ_FRAMEBUFFER_BINDING, &read_);
    glGetIntegerv(GL_VIEWPORT, viewport_);
  }
  ~BoundFramebuffer() {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<GLuint>(draw_));
    glBindFramebuffer(GL_READ_FRAMEBUFFER, static_cast<GLuint>(read_));
    glViewport(viewport_[0], viewport_[1], viewport_[2], viewport_[3]);
  }
  BoundFramebuffer(const BoundFramebuffer&) = delete;
  BoundFramebuffer& operator=(const BoundFramebuffer&) = delete;

 private:
  GLint draw_ = 0, read_ = 0, viewport_[4] = {};
};

/// Resolves the two color attachments of a multisampled framebuffer into those of another one of the same size. Leaves
/// both bound, the latter with both attachments enabled for drawing.
inline void resolve_attachments(const Framebuffer& multisampled, const Framebuffer& resolved, int width, int height) {
  constexpr GLenum kAttachments[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  glBindFramebuffer(GL_READ_FRAMEBUFFER, multisampled.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved.id());
  for (const GLenum attachment : kAttachments) {
    const GLenum buffers[] = {attachment == kAttachments[0] ? attachment : GL_NONE,
                              attachment == kAttachments[1] ? attachment : GL_NONE};
    glReadBuffer(attachment);
    glDrawBuffers(2, buffers);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  glDrawBuffers(2, kAttachments);
}

}  // namespace griffith::render
