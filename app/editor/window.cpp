#include "app/editor/window.h"

#include <backends/imgui_impl_glfw.h>
#include <epoxy/gl.h>
// After the GL loader.
#include <GLFW/glfw3.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cfloat>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/frame_schedule.h"
#include "app/editor/imgui_context_owner.h"
#include "app/editor/messages.h"
#include "app/editor/preferences_file.h"
#include "app/editor/script_player.h"
#include "app/editor/starting_scene.h"
#include "app/output/output.h"
#include "app/shared/processes.h"
#include "app/shared/scene_files.h"
#include "renderer/image.h"
#include "sim/core/replace_file.h"
#include "sim/scene/scene_reader.h"
#include "ui/model/input_queue.h"

namespace griffith::app {
namespace {

static_assert(ui::key::kSpace == GLFW_KEY_SPACE && ui::key::kEscape == GLFW_KEY_ESCAPE &&
              ui::key::kHome == GLFW_KEY_HOME && ui::key::kF1 == GLFW_KEY_F1 && ui::key::kF12 == GLFW_KEY_F12);
static_assert(ui::key::kLeftShift == GLFW_KEY_LEFT_SHIFT && ui::key::kRightSuper == GLFW_KEY_RIGHT_SUPER);

constexpr int kWidth = 1500, kHeight = 940;
constexpr int kMinWidth = 1024, kMinHeight = 600;  // design pixels; panels would overlap in a smaller window
constexpr double kLongestWait = 1;                 // seconds; copies of edits may become due

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
    fit_screen();
  }
  ~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
  }
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  GLFWwindow* handle() const { return window_; }

  /// Returns screen pixels per design pixel, in units of the window.
  float scale() const {
    float content = 1;
    int window_width = 1, buffer_width = 1;
    glfwGetWindowContentScale(window_, &content, nullptr);
    glfwGetWindowSize(window_, &window_width, nullptr);
    glfwGetFramebufferSize(window_, &buffer_width, nullptr);
    return content * static_cast<float>(std::max(window_width, 1)) / static_cast<float>(std::max(buffer_width, 1));
  }

 private:
  /// Limits the window to the screen, and to a usable size.
  void fit_screen() {
    int width = 0, height = 0, room_across = 0, room_down = 0;
    glfwGetWindowSize(window_, &width, &height);
    glfwGetMonitorWorkarea(glfwGetPrimaryMonitor(), nullptr, nullptr, &room_across, &room_down);
    if (room_across <= 0 || room_down <= 0) return;
    glfwSetWindowSize(window_, std::min(width, room_across), std::min(height, room_down));
    const float pixels = scale();
    glfwSetWindowSizeLimits(window_, std::min(static_cast<int>(kMinWidth * pixels), room_across),
                            std::min(static_cast<int>(kMinHeight * pixels), room_down), GLFW_DONT_CARE, GLFW_DONT_CARE);
  }

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

/// Passes the window's events to ImGui and dropped files to the editor.
class WindowInput {
 public:
  WindowInput(const Window& window, Editor& editor) : editor_(editor) {
    GLFWwindow* handle = window.handle();
    ImGui_ImplGlfw_InitForOpenGL(handle, true);
    glfwSetWindowUserPointer(handle, this);
    // These replace ImGui's callbacks, which lose taps between two frames.
    glfwSetKeyCallback(handle, [](GLFWwindow* from, int key, int, int action, int) {
      if (action != GLFW_REPEAT) of(from).queue_.key(key, action == GLFW_PRESS);
    });
    glfwSetCharCallback(handle, [](GLFWwindow* from, unsigned int character) { of(from).queue_.text(character); });
    glfwSetMouseButtonCallback(handle, [](GLFWwindow* from, int button, int action, int) {
      of(from).expect_cursor();
      of(from).queue_.button(button, action == GLFW_PRESS);
    });
    glfwSetScrollCallback(handle, [](GLFWwindow* from, double right, double up) {
      of(from).expect_cursor();
      of(from).queue_.scroll(static_cast<float>(right), static_cast<float>(up));
    });
    glfwSetCursorPosCallback(handle, [](GLFWwindow* from, double x, double y) { of(from).move(x, y); });
    glfwSetCursorEnterCallback(handle, [](GLFWwindow* from, int entered) {
      ImGui_ImplGlfw_CursorEnterCallback(from, entered);
      if (!entered && !ImGui::IsAnyMouseDown()) of(from).move(-FLT_MAX, -FLT_MAX);
    });
    glfwSetDropCallback(handle, [](GLFWwindow* from, int count, const char** paths) {
      if (count > 0) of(from).editor_.execute({.name = "file.open_path", .path = paths[0]});
    });
  }
  ~WindowInput() { ImGui_ImplGlfw_Shutdown(); }
  WindowInput(const WindowInput&) = delete;
  WindowInput& operator=(const WindowInput&) = delete;

  ui::InputQueue& queue() { return queue_; }

  /// Passes the window's state and the events of the next frame to ImGui.
  void begin_frame() {
    ImGui_ImplGlfw_NewFrame();
    ImGuiIO& io = ImGui::GetIO();
    std::ranges::copy(buttons_, io.MouseDown);  // the backend has read the current state
    queue_.play(io);
    std::ranges::copy(io.MouseDown, buttons_.begin());
  }

 private:
  static WindowInput& of(GLFWwindow* handle) { return *static_cast<WindowInput*>(glfwGetWindowUserPointer(handle)); }

  void move(double x, double y) {
    cursor_ = {static_cast<float>(x), static_cast<float>(y)};
    queue_.move(cursor_);
  }

  /// Returns ImGui's mouse to the cursor, from which a script may have moved it.
  void expect_cursor() { queue_.expect_at(cursor_); }

  Editor& editor_;
  ui::InputQueue queue_;
  ImVec2 cursor_ = {-FLT_MAX, -FLT_MAX};                   ///< where the last event has put the cursor
  std::array<bool, ImGuiMouseButton_COUNT> buttons_ = {};  ///< as of the last frame
};

/// Reads the window's current picture.
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

std::string graphics_of_window() {
  const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  return name ? name : "unknown";
}

void draw_frame(Editor& editor, ImGuiContextOwner& imgui, const Window& window, WindowInput& input) {
  editor.draw_picture(std::nullopt);
  input.begin_frame();
  imgui.begin_frame();
  editor.draw_panels(imgui.fonts());
  int width = 0, height = 0;
  glfwGetFramebufferSize(window.handle(), &width, &height);
  glViewport(0, 0, width, height);
  glClearColor(0, 0, 0, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  imgui.end_frame();
}

void save_window(const std::filesystem::path& path, Editor& editor, const Window& window) {
  try {
    save_picture(path, window_image(window));
    log_message(editor.state(), ui::LogLevel::info, "Saved " + path.string());
  } catch (const InputError& error) {
    log_message(editor.state(), ui::LogLevel::error, error.what());
  }
}

/// Continues the script being played, or begins the requested tour or macro. An error in a line ends it.
void play_script(std::optional<ScriptPlayer>& player, Editor& editor, WindowInput& input) {
  if (std::optional<Script> script = player ? std::nullopt : editor.scripting().take_request())
    player.emplace(std::move(*script), true);
  if (!player) return;
  try {
    player->advance(editor, input.queue());
  } catch (const InputError& error) {
    editor.state().caption.reset();
    show_error(editor.state(), error);
    player.reset();
  }
}

/// Reads the user's preferences; a damaged file is reported and kept until something changes.
ui::Preferences read_preferences(PreferencesFile& file, Editor& editor) {
  try {
    return file.read();
  } catch (const InputError& error) {
    show_error(editor.state(), error);
    return {};
  }
}

/// Applies the preferred size, and saves changes once the mouse is released.
void follow_preferences(PreferencesFile& file, Editor& editor, ImGuiContextOwner& imgui, const Window& window) {
  ui::EditorState& state = editor.state();
  const float scale = window.scale() * static_cast<float>(state.preferences.ui_scale);
  if (imgui.set_scale(scale)) {
    state.left_width = state.right_width = 0;
    state.plots.height = state.log_view.height = state.problem_view.height = 0;
  }
  if (ImGui::IsAnyMouseDown()) return;
  try {
    file.keep(state.preferences);
  } catch (const InputError& error) {
    log_message(editor.state(), ui::LogLevel::warning, error.what());
  }
}

/// Runs the scene of users without one of their own, until something breaks and is explained.
void begin_first_run(Editor& editor) {
  editor.state().explain_first_crack = true;
  editor.execute({.name = "simulation.run"});
  log_message(editor.state(), ui::LogLevel::info,
              "The panel on the right explains why it broke. Right-click the wall to fire at it. See Help > Tour.",
              ui::LogSpan::advice);
}

/// Waits a limited time until there is something to draw. True if there is. `step_ended`: a step has woken the window;
/// other than an event of the user, it asks for one frame alone.
bool wait_for_frame(FrameSchedule& schedule, double until_next, std::atomic<bool>& step_ended) {
  constexpr double kInexact = 0.005;  // the wait may end early by so much [s]
  const double seconds = schedule.seconds_to_wait(until_next), until = glfwGetTime() + std::min(seconds, kLongestWait);
  if (step_ended.exchange(false) || seconds <= kDrawAtOnce) {
    glfwPollEvents();
    return true;
  }
  glfwWaitEventsTimeout(std::min(seconds, kLongestWait));
  const bool woken = glfwGetTime() < until - kInexact;
  if (woken && !step_ended.exchange(false)) schedule.wake();
  return woken || seconds <= kLongestWait;
}

/// Returns the seconds until the window draws by itself.
double seconds_to_next_frame(const Editor& editor, WindowInput& input, bool plays) {
  const ImGuiIO& io = ImGui::GetIO();
  const bool held = ImGui::IsAnyMouseDown() || std::ranges::find(io.KeysDown, true) != std::end(io.KeysDown);
  return held || plays || !input.queue().empty() ? kDrawAtOnce : editor.seconds_to_next_frame();
}

void autosave(Editor& editor, FrameSchedule& schedule, double now) {
  const std::size_t said = editor.state().log.size();
  editor.recovery().copy(now);
  if (editor.state().log.size() != said) schedule.wake();
}

/// Sets the window's title, only if it differs because that causes an event.
void show_title(const Window& window, std::string& shown, std::string title) {
  if (title == shown) return;
  shown = std::move(title);
  glfwSetWindowTitle(window.handle(), shown.c_str());
}

void loop(Editor& editor, ImGuiContextOwner& imgui, const Window& window, WindowInput& input,
          std::optional<ScriptPlayer> player, PreferencesFile& preferences, int exit_after,
          std::atomic<bool>& step_ended) {
  FrameSchedule schedule;
  std::string title;
  double last = glfwGetTime();
  for (int drawn = 0; !editor.requests().quit;) {
    const bool waits_for_reader = editor.state().caption && editor.state().caption->answer == ui::Caption::Answer::none;
    const bool plays = exit_after > 0 || (player && !waits_for_reader && !ui::is_busy(editor.state()));
    const bool draws = wait_for_frame(schedule, seconds_to_next_frame(editor, input, plays), step_ended);
    if (glfwWindowShouldClose(window.handle())) {
      glfwSetWindowShouldClose(window.handle(), GLFW_FALSE);
      editor.execute({.name = "file.quit"});
    }
    const double now = glfwGetTime();
    autosave(editor, schedule, now);
    if (!draws) continue;
    editor.run().advance(now - last);
    last = now;
    play_script(player, editor, input);
    follow_preferences(preferences, editor, imgui, window);
    const auto request = editor.files().take_picture_request();  // its dialog is gone from the next drawn frame
    draw_frame(editor, imgui, window, input);
    if (request)
      editor.files().save_window_picture(*request, window_image(window), editor.tags(), graphics_of_window());
    if (std::exchange(editor.requests().screenshot, false)) save_window(free_screenshot_path(), editor, window);
    if (const auto file = player ? player->take_picture_request() : std::nullopt) save_window(*file, editor, window);
    if (player && player->done()) player.reset();
    schedule.drew();
    if (++drawn == exit_after) return;
    show_title(window, title, editor.document().title());
    glfwSwapBuffers(window.handle());
  }
}

}  // namespace

void run_editor(const EditorOptions& options) {
  if (!options.screenshot.empty()) check_replaceable(options.screenshot);
  const bool named = !options.scene.empty();
  const Scene scene = named ? read_scene(options.scene) : starting_scene();
  const Scene shown = named ? read_scene(options.scene, options.settings) : scene;
  std::optional<ScriptPlayer> player;
  if (!options.script.empty()) player.emplace(read_script(options.script), true);
  const Window window;
  std::atomic<bool> step_ended = false;
  Editor editor(scene, options.scene, shown == scene ? nullptr : &shown);
  PreferencesFile preferences(preferences_path());
  editor.state().preferences = read_preferences(preferences, editor);
  ImGuiContextOwner imgui(window.scale());
  WindowInput input(window, editor);
  editor.enable_autosave(state_folder());
  editor.scenes().show_thumbnails({this_program(), thumbnail_cache()});
  editor.scripting().use_macros(macro_folder());
  editor.run().step_in_background([&step_ended] {
    step_ended = true;
    glfwPostEmptyEvent();
  });
  editor.viewport().allow_drafts();
  if (!named) begin_first_run(editor);
  loop(editor, imgui, window, input, std::move(player), preferences, options.exit_after, step_ended);
  if (!options.screenshot.empty()) save_picture(options.screenshot, window_image(window));
}

}  // namespace griffith::app
