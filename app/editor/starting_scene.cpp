#include "app/editor/starting_scene.h"

namespace griffith::app {

Scene starting_scene() {
  BodyDescription wall;
  wall.name = "wall";
  wall.shape = BoxShape{Vec3(3, 2, 0.3), Vec3(0.25, 0.25, 0.15), BoxPattern::five_tet};
  wall.position = Vec3(0, 1, 0);
  wall.supports = {{BoxRegion{Vec3(-1.5, -1, -0.15), Vec3(1.5, -1, 0.15)}}};
  Scene scene;
  scene.name = "brick wall";
  scene.bodies = {wall};
  scene.cameras = {{"main", Vec3(2.6, 2.2, 5.4), Vec3(0, 0.9, 0), 40}};
  return scene;
}

}  // namespace griffith::app
