#include "app/editor/starting_scene.h"

#include <app/editor/first_scene.h>

#include "sim/scene/scene_reader.h"

namespace griffith::app {

Scene starting_scene() { return scene_from_json(brick_wall_json, "scenes/brick_wall.json"); }

}  // namespace griffith::app
