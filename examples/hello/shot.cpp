#include <griffith/scene.h>
#include <griffith/world.h>

#include <cstdio>

int main() {
  griffith::World world(griffith::read_scene("scenes/glass_pane.json"));
  for (int step = 0; step < 60; ++step) world.step();
  for (const griffith::BodyView& piece : world.frame().bodies) std::printf("%.3f kg\n", piece.mass);
}
