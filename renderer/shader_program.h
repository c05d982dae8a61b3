#pragma once

#include <string>

#include "renderer/camera.h"
#include "renderer/color.h"
#include "renderer/gl_objects.h"
#include "renderer/renderer.h"

namespace griffith::render {

/// Texture units of all programs; every sampler is bound to the unit of its name.
enum TextureUnit : int {
  kShadowUnit,
  kColorTableUnit,
  kScalarsUnit,
  kColorsUnit,
  kIdsUnit,
  kFlagsUnit,
  kPointsUnit,
  kTetsUnit,
  kCarriersUnit,
  kMaterialsUnit,
  kColorSumsUnit,
  kWeightSumsUnit,
  kShadowDepthUnit,
  kOcclusionUnit,
  kClearShadowUnit,
  kOpaqueUnit,
  kFaceSumsUnit,
  kOpaqueDistanceUnit,
  kMattersUnit
};

/// Output of a fragment shader that calls emit() of shaders/output.glsl or emit_glass() of glass.glsl: a Target, a
/// BlendTarget or a GlassTarget.
enum class Output { opaque, transparent, glass };
std::string with_output(const std::string& fragment_source, Output output);

/// Part of a surface to draw.
enum class DrawnPart : int { all, selected, unselected, not_clear, clear };

/// Light in fragment shaders: `plain`, for drafts, is one lamp with hard shadows at low cost.
enum class Light { full, plain };
inline Light light_of(Quality quality) { return quality == Quality::draft ? Light::plain : Light::full; }

/// A linked program of a vertex and a fragment shader, each preceded by shaders/common.glsl, the latter by light.glsl
/// too. Throws RenderError with `name`, the stage and the driver's log if one is rejected.
class ShaderProgram {
 public:
  ShaderProgram(const std::string& name, const char* vertex_source, const char* fragment_source,
                Light light = Light::full);

  void use() const { glUseProgram(program_.id()); }

  // The program must be in use; a name that the linker dropped is ignored.
  void set(const char* uniform, int value) const { glUniform1i(location(uniform), value); }
  void set(const char* uniform, float value) const { glUniform1f(location(uniform), value); }
  void set(const char* uniform, float x, float y) const { glUniform2f(location(uniform), x, y); }
  void set(const char* uniform, const Rgb& color) const { glUniform3f(location(uniform), color.r, color.g, color.b); }
  void set(const char* uniform, const Mat4& matrix) const {
    glUniformMatrix4fv(location(uniform), 1, GL_FALSE, matrix.data());
  }
  void set(const char* uniform, float x, float y, float z) const { glUniform3f(location(uniform), x, y, z); }

 private:
  GLint location(const char* uniform) const { return glGetUniformLocation(program_.id(), uniform); }

  Program program_;
};

/// One program for each light.
class LitProgram {
 public:
  LitProgram(const std::string& name, const char* vertex_source, const std::string& fragment_source)
      : full_(name, vertex_source, fragment_source.c_str()),
        plain_("plainly lit " + name, vertex_source, fragment_source.c_str(), Light::plain) {}

  const ShaderProgram& in(Light light) const { return light == Light::full ? full_ : plain_; }

 private:
  ShaderProgram full_, plain_;
};

}  // namespace griffith::render
