#pragma once

#include <memory>
#include <optional>
#include <string>

namespace griffith::render {

struct EglState;

/// An OpenGL 3.3 core context (or newer) without window or display, current on the thread that made it. Move-only.
class EglContext {
 public:
  /// Tries only device `device_index` of the enumeration if one is given. Otherwise tries the hardware devices in
  /// order, then Mesa's surfaceless platform, then software devices. Throws RenderError with the error of every
  /// attempt, or with the name of the missing library.
  explicit EglContext(std::optional<int> device_index = std::nullopt);
  ~EglContext();
  EglContext(EglContext&&) noexcept;
  EglContext& operator=(EglContext&&) noexcept;

  void make_current() const;

  const std::string& renderer() const;  ///< GL_RENDERER
  const std::string& version() const;   ///< GL_VERSION
  const std::string& origin() const;    ///< origin of the context, e.g. "device 0" or "surfaceless"

 private:
  std::unique_ptr<EglState> state_;
};

}  // namespace griffith::render
