// Draws a ball without a window and prints the content of the picture's center.
#include <griffith/renderer/egl_context.h>
#include <griffith/renderer/renderer.h>

#include <cstdio>

using namespace griffith::render;

int main() {
  const EglContext context;
  DrawScene scene;
  scene.spheres = {{.id = 7}};
  Renderer renderer;
  renderer.render(scene, frame_bounds(Camera(), bounds(scene), 1), {.width = 64, .height = 64});
  std::printf("id %d\n", renderer.id_at(32, 32));
}
