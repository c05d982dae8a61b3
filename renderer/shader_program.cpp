#include "renderer/shader_program.h"

#include <iterator>
#include <utility>

#include "renderer/error.h"
#include "renderer/shaders.h"
#include "renderer/view.h"

namespace griffith::render {
namespace {

template <class GetParameter, class GetLog>
std::string read_log(GLuint object, GetParameter get_parameter, GetLog get_log) {
  GLint length = 0;
  get_parameter(object, GL_INFO_LOG_LENGTH, &length);
  std::string log(static_cast<std::size_t>(length), '\0');
  if (length > 0) get_log(object, length, nullptr, log.data());
  return log.c_str();
}

void attach_stage(GLuint program, GLenum stage, const std::string& name, const char* source, Light light) {
  const bool is_fragment = stage == GL_FRAGMENT_SHADER, is_plain = light == Light::plain;
  const char* parts[] = {"#version 330 core\n",
                         is_plain ? "#define PLAIN_LIGHT\n" : "",
                         shaders::common_glsl,
                         is_fragment && !is_plain ? shaders::environment_glsl : "",
                         is_fragment ? shaders::light_glsl : "",
                         "#line 1 1\n",
                         source};
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, static_cast<GLsizei>(std::size(parts)), parts, nullptr);
  glCompileShader(shader);
  GLint compiled = 0;
  glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  const std::string log = compiled ? "" : read_log(shader, glGetShaderiv, glGetShaderInfoLog);
  glAttachShader(program, shader);
  glDeleteShader(shader);  // exists as long as the program
  if (!compiled) {
    throw RenderError("the driver rejects the " + std::string(stage == GL_VERTEX_SHADER ? "vertex" : "fragment") +
                      " shader of " + name + ":\n" + log);
  }
}

}  // namespace

std::string with_output(const std::string& fragment_source, Output output) {
  if (output == Output::glass) return "#define GLASS\n" + std::string(shaders::glass_glsl) + fragment_source;
  const char* prefix = output == Output::transparent ? "#define TRANSPARENT\n" : "";
  return prefix + std::string(shaders::output_glsl) + fragment_source;
}

ShaderProgram::ShaderProgram(const std::string& name, const char* vertex_source, const char* fragment_source,
                             Light light) {
  attach_stage(program_.id(), GL_VERTEX_SHADER, name, vertex_source, light);
  attach_stage(program_.id(), GL_FRAGMENT_SHADER, name, fragment_source, light);
  glLinkProgram(program_.id());
  GLint linked = 0;
  glGetProgramiv(program_.id(), GL_LINK_STATUS, &linked);
  if (!linked) {
    throw RenderError("the driver can't link " + name + ":\n" +
                      read_log(program_.id(), glGetProgramiv, glGetProgramInfoLog));
  }
  const GLuint block = glGetUniformBlockIndex(program_.id(), "View");
  if (block != GL_INVALID_INDEX) glUniformBlockBinding(program_.id(), block, kViewBinding);
  use();
  const std::pair<const char*, int> samplers[] = {{"shadow_map", kShadowUnit},
                                                  {"color_table", kColorTableUnit},
                                                  {"scalars", kScalarsUnit},
                                                  {"colors", kColorsUnit},
                                                  {"ids", kIdsUnit},
                                                  {"flags", kFlagsUnit},
                                                  {"points", kPointsUnit},
                                                  {"tets", kTetsUnit},
                                                  {"carriers", kCarriersUnit},
                                                  {"materials", kMaterialsUnit},
                                                  {"matters", kMattersUnit},
                                                  {"color_sums", kColorSumsUnit},
                                                  {"weight_sums", kWeightSumsUnit},
                                                  {"shadow_depth", kShadowDepthUnit},
                                                  {"occlusion_map", kOcclusionUnit},
                                                  {"clear_shadow_map", kClearShadowUnit},
                                                  {"scene_depth", kOcclusionUnit},
                                                  {"raw_occlusion", kOcclusionUnit},
                                                  {"opaque_picture", kOpaqueUnit},
                                                  {"depth_sums", kColorSumsUnit},
                                                  {"light_sums", kWeightSumsUnit},
                                                  {"face_sums", kFaceSumsUnit},
                                                  {"opaque_depth", kOpaqueDistanceUnit},
                                                  {"opaque_distance", kOpaqueDistanceUnit}};
  for (const auto& [sampler, unit] : samplers) set(sampler, unit);
}

}  // namespace griffith::render
