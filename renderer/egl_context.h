#pragma once

#include <memory>
#include <optional>
#include <string>

namespace griffith::render {

struct EglState;

/// An OpenGL 3.3 core context (or newer) without window or display, current on the thread that made it.
/// Move-only.
class EglContext {
 public:
  /// Tries device `device_index` of the enumeration if one is given (then nothing else), or else the hardware devices
  /// in turn, then Mesa's surfaceless platform, then software devices. Throws RenderError that lists every attempt and
  /// why it failed, or says which library is missing.
  explicit EglContext(std::optional<int> device_index = std::nullopt);
  ~EglContext();
  EglContext(EglContext&&) noexcept;
  EglContext& operator=(EglContext&&) noexcept;

  void make_current() const;

  const std::string& renderer() const;  ///< GL_RENDERER
  const std::string& version() const;   ///< GL_VERSION
  const std::string& origin() const;    ///< how it was made, e.g. "device 0" or "surfaceless"

 private:
  std::unique_ptr<EglState> state_;
};

}  // namespace griffith::render
