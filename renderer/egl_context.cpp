#include "renderer/egl_context.h"

#include <dlfcn.h>
#include <epoxy/egl.h>
#include <epoxy/gl.h>

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>
#include <vector>

#include "renderer/error.h"

namespace griffith::render {

struct EglState {
  // The display belongs to the process and is shared by all contexts on its device: it is never terminated.
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::string renderer, version, origin;

  EglState() = default;
  EglState(const EglState&) = delete;
  EglState& operator=(const EglState&) = delete;
  ~EglState() {
    if (context == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == context) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, context);
  }
};

namespace {

std::string egl_error(const std::string& what) {
  const EGLint code = eglGetError();
  switch (code) {
    case EGL_NOT_INITIALIZED:
      return what + " failed: EGL_NOT_INITIALIZED (no driver for it, or no permission)";
    case EGL_BAD_ALLOC:
      return what + " failed: EGL_BAD_ALLOC (out of memory)";
    case EGL_BAD_MATCH:
      return what + " failed: EGL_BAD_MATCH (OpenGL 3.3 core not supported)";
    default: {
      constexpr char kDigits[] = "0123456789abcdef";
      std::string digits;
      for (int shift = 12; shift >= 0; shift -= 4) digits += kDigits[(code >> shift) & 15];
      return what + " failed: EGL error 0x" + digits;
    }
  }
}

/// Loads one of the libraries permanently. Returns the error if none can be loaded, else an empty text.
std::string loading_error(std::initializer_list<const char*> libraries) {
  std::string reasons;
  for (const char* library : libraries) {
    if (dlopen(library, RTLD_LAZY | RTLD_GLOBAL)) return {};
    reasons += std::string("\n  ") + dlerror();
  }
  return reasons;
}

/// Throws RenderError if libraries are missing for which libepoxy would abort the program.
void require_libraries() {
  if (const std::string reason = loading_error({"libEGL.so.1"}); !reason.empty())
    throw RenderError("no EGL, which pictures without a window need (Debian's package is libegl1):" + reason);
  if (const std::string reason = loading_error({"libOpenGL.so.0", "libGL.so.1"}); !reason.empty())
    throw RenderError("no OpenGL (Debian's package is libopengl0):" + reason);
}

bool client_has(const char* extension) { return epoxy_has_egl_extension(EGL_NO_DISPLAY, extension); }

std::vector<EGLDeviceEXT> devices() {
  const bool enumerable = client_has("EGL_EXT_device_enumeration") || client_has("EGL_EXT_device_base");
  if (!enumerable || !client_has("EGL_EXT_platform_device")) return {};
  EGLint count = 0;
  if (!eglQueryDevicesEXT(0, nullptr, &count) || count <= 0) return {};
  std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
  if (!eglQueryDevicesEXT(count, found.data(), &count)) return {};
  found.resize(static_cast<std::size_t>(count));
  return found;
}

bool is_software(EGLDeviceEXT device) {
  const char* extensions = eglQueryDeviceStringEXT(device, EGL_EXTENSIONS);
  return extensions && std::string_view(extensions).find("EGL_MESA_device_software") != std::string_view::npos;
}

/// One way to create a context: platform and name of a display.
struct DisplayAttempt {
  EGLenum platform;
  void* native_display;
  std::string name;
  bool maybe_hardware;
};

/// Returns the attempts in order.
std::vector<DisplayAttempt> attempts() {
  std::vector<DisplayAttempt> hardware, software;
  const std::vector<EGLDeviceEXT> found = devices();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const std::string name = "device " + std::to_string(i);
    if (is_software(found[i])) {
      software.push_back({EGL_PLATFORM_DEVICE_EXT, found[i], name + " (software)", false});
    } else {
      hardware.push_back({EGL_PLATFORM_DEVICE_EXT, found[i], name, true});
    }
  }
  if (client_has("EGL_MESA_platform_surfaceless")) {
    hardware.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, "surfaceless", false});
  }
  hardware.insert(hardware.end(), software.begin(), software.end());
  return hardware;
}

void open_display(EglState& state, const DisplayAttempt& attempt) {
  state.display = eglGetPlatformDisplayEXT(attempt.platform, attempt.native_display, nullptr);
  if (state.display == EGL_NO_DISPLAY) throw RenderError(egl_error("eglGetPlatformDisplay"));
  if (!eglInitialize(state.display, nullptr, nullptr)) throw RenderError(egl_error("eglInitialize"));
  if (!epoxy_has_egl_extension(state.display, "EGL_KHR_surfaceless_context")) {
    throw RenderError("it lacks EGL_KHR_surfaceless_context");
  }
}

void create_context(EglState& state) {
  if (!eglBindAPI(EGL_OPENGL_API)) throw RenderError(egl_error("eglBindAPI(EGL_OPENGL_API)"));
  const EGLint attributes[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (!eglChooseConfig(state.display, attributes, &config, 1, &count)) throw RenderError(egl_error("eglChooseConfig"));
  if (count == 0) throw RenderError("it has no configuration for OpenGL");
  const EGLint version[] = {
      EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
      EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
  state.context = eglCreateContext(state.display, config, EGL_NO_CONTEXT, version);
  if (state.context == EGL_NO_CONTEXT) throw RenderError(egl_error("eglCreateContext"));
  if (!eglMakeCurrent(state.display, EGL_NO_SURFACE, EGL_NO_SURFACE, state.context)) {
    throw RenderError(egl_error("eglMakeCurrent"));
  }
}

std::string gl_string(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text ? reinterpret_cast<const char*>(text) : "";
}

/// Returns a current context. Throws RenderError with the reason.
std::unique_ptr<EglState> make_context(const DisplayAttempt& attempt) {
  auto state = std::make_unique<EglState>();
  open_display(*state, attempt);
  create_context(*state);
  state->renderer = gl_string(GL_RENDERER);
  state->version = gl_string(GL_VERSION);
  state->origin = attempt.name;
  return state;
}

std::vector<DisplayAttempt> only_device(std::vector<DisplayAttempt> all, int index) {
  const std::string name = "device " + std::to_string(index);
  std::erase_if(
      all, [&](const DisplayAttempt& attempt) { return attempt.name != name && attempt.name != name + " (software)"; });
  return all;
}

std::string list_of_names(const std::vector<DisplayAttempt>& all) {
  std::string names;
  for (const DisplayAttempt& attempt : all) names += (names.empty() ? "" : ", ") + attempt.name;
  return names.empty() ? "none" : names;
}

}  // namespace

EglContext::EglContext(std::optional<int> device_index) {
  require_libraries();
  const std::vector<DisplayAttempt> all = attempts();
  const std::vector<DisplayAttempt> chosen = device_index ? only_device(all, *device_index) : all;
  std::string tried;
  for (const DisplayAttempt& attempt : chosen) {
    if (state_ && !attempt.maybe_hardware) break;
    try {
      std::unique_ptr<EglState> made = make_context(attempt);
      const bool hardware = made->renderer.find("llvmpipe") == std::string::npos;
      if (hardware || !state_) state_ = std::move(made);
      if (hardware) break;
    } catch (const RenderError& error) {
      tried += "\n  " + attempt.name + ": " + error.what();
    }
  }
  if (state_) {
    make_current();
    return;
  }
  if (device_index && chosen.empty())
    tried = "\n  device " + std::to_string(*device_index) + ": there is no such device";
  if (tried.empty()) tried = "\n  nothing: EGL offers neither device enumeration nor the surfaceless platform";
  throw RenderError("no OpenGL 3.3 context without a window. Tried:" + tried + "\nAvailable: " + list_of_names(all));
}

EglContext::~EglContext() = default;
EglContext::EglContext(EglContext&&) noexcept = default;
EglContext& EglContext::operator=(EglContext&&) noexcept = default;

void EglContext::make_current() const {
  if (!eglMakeCurrent(state_->display, EGL_NO_SURFACE, EGL_NO_SURFACE, state_->context)) {
    throw RenderError(egl_error("eglMakeCurrent"));
  }
}

const std::string& EglContext::renderer() const { return state_->renderer; }
const std::string& EglContext::version() const { return state_->version; }
const std::string& EglContext::origin() const { return state_->origin; }

}  // namespace griffith::render
