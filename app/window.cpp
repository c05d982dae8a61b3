#include <backends/imgui_impl_glfw.h>
#include <epoxy/gl.h>
// After the GL loader.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <string>

#include "app/command_options.h"
#include "app/editor.h"
#include "app/interface.h"
#include "app/key_latch.h"
#include "app/output.h"
#include "app/scene_files.h"
#include "app/starting_scene.h"
#include "renderer/image.h"
#include "sim/replace_file.h"
#include "sim/scene/scene_reader.h"

namespace griffith::app {
namespace {

static_assert(ui::key::kSpace == GLFW_KEY_SPACE && ui::key::kEscape == GLFW_KEY_ESCAPE &&
              ui::key::kHome == GLFW_KEY_HOME && ui::key::kF1 == GLFW_KEY_F1 && ui::key::kF12 == GLFW_KEY_F12);

constexpr int kWidth = 1500, kHeight = 940, kSamples = 4;
constexpr double kLongestFrame = 0.25;  // seconds; what is longer was an interruption

/// GLFW and its one window, with its OpenGL context current.
class Window {
 public:
  Window() {
    if (!glfwInit()) fail();
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    window_ = glfwCreateWindow(kWidth, kHeight, "Griffith", nullptr, nullptr);
    if (!window_) fail();
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
  }
  ~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }

  /// Screen pixels per design pixel, in the units in which the window counts.
  float scale() const {
    float content = 1;
    int window_width = 1, buffer_width = 1;
    glfwGetWindowContentScale(window_, &content, nullptr);
    glfwGetWindowSize(window_, &window_width, nullptr);
    glfwGetFramebufferSize(window_, &buffer_width, nullptr);
    return content * static_cast<float>(std::max(window_width, 1)) / static_cast<float>(std::max(buffer_width, 1));
  }

 private:
  [[noreturn]] static void fail() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    const std::string text = std::string("no window can be opened") + (reason ? std::string(": ") + reason : "") +
                             ". Without a display, use: griffith render SCENE --frame N -o OUT.png";
    glfwTerminate();
    throw std::runtime_error(text);
  }

  GLFWwindow* window_ = nullptr;
};

/// The window's events on their way to ImGui and, for dropped files, to the editor.
class WindowInput {
 public:
  WindowInput(const Window& window, Editor& editor) : window_(window.handle()), editor_(editor) {
    ImGui_ImplGlfw_InitForOpenGL(window_, true);
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* handle, int key, int scancode, int action, int mods) {
      of(handle).tell_key(key, scancode, action, mods);
    });
    glfwSetDropCallback(window_, [](GLFWwindow* handle, int count, const char** paths) {
      if (count > 0) of(handle).editor_.execute({.id = ui::CommandId::open, .path = paths[0]});
    });
  }
  ~WindowInput() { ImGui_ImplGlfw_Shutdown(); }
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;

  /// To be called once a frame, after ImGui has read the keys.
  void end_frame() {
    for (const int key : keys_.end_frame()) ImGui_ImplGlfw_KeyCallback(window_, key, 0, GLFW_RELEASE, 0);
  }

 private:
  static WindowInput& of(GLFWwindow* handle) { return *static_cast<WindowInput*>(glfwGetWindowUserPointer(handle)); }

  void tell_key(int key, int scancode, int action, int mods) {
    if (action == GLFW_PRESS) keys_.press(key);
    if (action == GLFW_RELEASE && !keys_.release(key)) return;
    ImGui_ImplGlfw_KeyCallback(window_, key, scancode, action, mods);
  }

  GLFWwindow* window_;
  Editor& editor_;
  KeyLatch keys_;
};

/// What is in the window now.
render::Image window_image(const Window& window) {
  render::Image image;
  glfwGetFramebufferSize(window.handle(), &image.width, &image.height);
  const std::size_t row = static_cast<std::size_t>(image.width) * 4;
  image.rgba.resize(row * static_cast<std::size_t>(image.height));
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, image.rgba.data());
  for (int y = 0; y < image.height / 2; ++y) {  // OpenGL counts rows from below
    const auto top = image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * y;
    const auto bottom = image.rgba.begin() + static_cast<std::ptrdiff_t>(row) * (image.height - 1 - y);
    std::swap_ranges(top, top + static_cast<std::ptrdiff_t>(row), bottom);
  }
  for (std::size_t i = 3; i < image.rgba.size(); i += 4) image.rgba[i] = 255;
  return image;
}

void save_screenshot(Editor& editor, const Window& window) {
  const std::filesystem::path path = free_screenshot_path();
  try {
    save_picture(path, window_image(window));
    editor.log(ui::LogLevel::info, "Saved " + path.string());
  } catch (const InputError& error) {
    editor.log(ui::LogLevel::error, error.what());
  }
}

void draw_frame(Editor& editor, Interface& interface, const Window& window, WindowInput& input) {
  editor.draw_picture(kSamples);
  ImGui_ImplGlfw_NewFrame();
  interface.begin_frame();
  input.end_frame();
  editor.draw_panels(interface.fonts());
  int width = 0, height = 0;
  glfwGetFramebufferSize(window.handle(), &width, &height);
  glViewport(0, 0, width, height);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  interface.end_frame();
}

void loop(Editor& editor, Interface& interface, const Window& window, WindowInput& input, int exit_after) {
  double last = glfwGetTime();
  for (int drawn = 1; !editor.wants_to_quit(); ++drawn) {
    glfwPollEvents();
    if (glfwWindowShouldClose(window.handle())) {
      glfwSetWindowShouldClose(window.handle(), GLFW_FALSE);
      editor.execute({.id = ui::CommandId::quit});
    }
    const double now = glfwGetTime();
    editor.advance(std::min(now - last, kLongestFrame));
    editor.autosave(now);
    last = now;
    draw_frame(editor, interface, window, input);
    if (editor.take_screenshot_request()) save_screenshot(editor, window);
    if (drawn == exit_after) return;
    glfwSetWindowTitle(window.handle(), editor.title().c_str());
    glfwSwapBuffers(window.handle());
  }
}

}  // namespace

void run_editor(const EditorOptions& options) {
  if (!options.screenshot.empty()) check_replaceable(options.screenshot);
  const bool named = !options.scene.empty();
  Scene scene = named ? read_scene(options.scene) : starting_scene();
  const Window window;
  Editor editor(std::move(scene), options.scene);
  Interface interface(window.scale());
  WindowInput input(window, editor);
  editor.keep_edits_safe(state_folder());
  loop(editor, interface, window, input, options.exit_after);
  if (!options.screenshot.empty()) save_picture(options.screenshot, window_image(window));
}

}  // namespace griffith::app
