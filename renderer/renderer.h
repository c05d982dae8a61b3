#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "renderer/camera.h"
#include "renderer/draw_scene.h"
#include "renderer/image.h"

namespace griffith::render {

/// Quality of lighting. Scalars without shading look the same in each.
enum class Quality {
  draft,     ///< plain light, hard shadows, no transparent materials
  standard,  ///< sky light with ambient occlusion, soft shadows, transparent materials
  high,      ///< like standard, with more samples
};

/// Part of a larger picture.
struct PicturePart {
  int left = 0, top = 0;                       ///< its upper left corner in the picture [pixels]
  int whole_width = 1280, whole_height = 720;  ///< size of the picture [pixels]
};

struct RenderOptions {
  int width = 1280, height = 720;   ///< size of what is drawn [pixels]
  std::optional<PicturePart> part;  ///< absent: the whole picture
  int samples = 1;                  ///< per pixel; 4 on screen, 1 for reproducible headless images
  bool edges = true;                ///< draws the edges marked in Surface::flags
  bool shadows = true;
  Quality quality = Quality::draft;
  bool unlit_scalars = false;  ///< draws scalars in exactly the legend's colors: no shading, no shadow
  float edge_width = 1.1f;     ///< [pixels]
  float pixel_scale = 1;       ///< factor on the widths of edges and lines and the diameters of points
};

/// Draws a DrawScene into its own pictures: usually one, or several by different cameras, which share the scene's
/// buffers. Construct and use it while one OpenGL 3.3 core context (or newer) is current. The same input gives the same
/// bytes. Throws RenderError if the driver rejects a shader.
class Renderer {
 public:
  Renderer();
  ~Renderer();
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Uploads the scene and draws picture 0. Leaves the framebuffer binding and viewport as they were.
  void render(const DrawScene& scene, const Camera& camera, const RenderOptions& options = {});

  /// Uploads the scene for draw(). `pixel_scale`: that of the pictures.
  void upload(const DrawScene& scene, float pixel_scale);
  /// Draws a picture, numbered from 0, of the scene uploaded last. Leaves the framebuffer binding and viewport as they
  /// were.
  void draw(const DrawScene& scene, const Camera& camera, const RenderOptions& options, std::size_t picture = 0);

  /// Returns a picture that was drawn, or picture 0: a GL_TEXTURE_2D whose first row is the bottom one (ImGui::Image:
  /// uv0 = (0, 1), uv1 = (1, 0)).
  unsigned color_texture(std::size_t picture = 0) const;

  /// Reads a picture that was drawn back.
  Image image(std::size_t picture = 0) const;

  /// Reads the ids of picture 0 back.
  IdImage ids() const;

  /// Returns the id at a pixel of a picture that was drawn, counted from the top left; kNoId for none or outside.
  std::int32_t id_at(int x, int y, std::size_t picture = 0) const;

 private:
  struct Passes;
  std::unique_ptr<Passes> passes_;
};

}  // namespace griffith::render
