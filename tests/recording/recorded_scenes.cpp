#include "recorded_scenes.h"

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/write_mesh.h"
#include "tests/files/test_folder.h"
#include "tests/meshing/surfaces.h"
#include "tests/world/scenes.h"

namespace griffith::testing {
namespace {

Scene of_shape(const Shape& shape, const std::filesystem::path& folder) {
  Scene scene = struck_wall();
  scene.bodies[0].shape = shape;
  scene.bodies[0].supports.clear();
  scene.folder = folder;
  return scene;
}

Scene sleeping_block() {
  Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].shape = BoxShape{Vec3(1, 1, 1), Vec3::Constant(1), BoxPattern::five_tet};
  scene.bodies[0].position = Vec3(0, 0.52, 0);
  return scene;
}

Scene splintered(const std::filesystem::path& folder) {
  Scene scene = struck_wall();
  scene.folder = folder;
  scene.bodies[0].splinters =
      PointSplinters{written(folder / "places.txt", "0 0 0\n0.5 0.5 0\n-0.5 0.3 0\n").filename()};
  scene.bodies[0].collision = CollisionShape::splinters;
  return scene;
}

Scene cut_wall() {
  Scene scene = struck_wall();
  scene.bodies[0].remeshing = true;
  return scene;
}

Scene shot_with_surface(const std::filesystem::path& folder) {
  Scene scene = struck_wall();
  scene.folder = folder;
  write_off(box_surface(Vec3::Constant(-0.1), Vec3::Constant(0.1)), folder / "cube.off");
  scene.projectiles[0].radius = ProjectileBurst().radius;
  scene.projectiles[0].shape = SurfaceProjectile{"cube.off"};
  return scene;
}

void write_csv(const TetSoup& soup, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  std::string points, tets;
  for (const Vec3& p : soup.points)
    points += std::to_string(p.x()) + "," + std::to_string(p.y()) + "," + std::to_string(p.z()) + "\n";
  for (const auto& [a, b, c, d] : soup.tets)
    tets += std::to_string(a) + "," + std::to_string(b) + "," + std::to_string(c) + "," + std::to_string(d) + "\n";
  written(folder / "verts.csv", points);
  written(folder / "tets.csv", tets);
}

}  // namespace

Scene struck_wall() {
  Scene scene = shot_wall(Vec3(2, 2, 0.25), 0.5, brick(0.05));
  scene.simulation.time_step = 1.0 / 60;
  scene.projectiles[0].start = 0;
  scene.projectiles[0].count = 1;
  scene.projectiles[0].position = Vec3(0.1, 1.2, 0.6);
  return scene;
}

std::vector<RecordedScene> recorded_scenes(const std::filesystem::path& folder) {
  const TetSoup soup = make_box(Vec3(2, 2, 0.25), Vec3::Constant(0.5), BoxPattern::kuhn);
  write_tetgen(folder / "wall.node", soup);
  write_csv(soup, folder / "wall_csv");
  write_off(box_surface(Vec3(-1, -1, -0.25), Vec3(1, 1, 0.25)), folder / "block.off");
  SurfaceShape surface;
  surface.path = "block.off";
  surface.meshing.element_size = 0.5;
  SurfaceShape lattice = surface;
  lattice.meshing.method = MeshingMethod::volumetric;
  Scene both = of_shape(surface, folder);
  both.bodies.push_back(both.bodies[0]);
  both.bodies[1].name = "other";
  both.bodies[1].shape = lattice;  // the same file, filled otherwise
  both.bodies[1].position = Vec3(5, 1, 0);
  return {{"cracks", struck_wall(), 14},
          {"cut tetrahedra", cut_wall(), 11},
          {"sleep", sleeping_block(), 90},
          {"TetGen's pair", of_shape(MeshFileShape{"wall.node"}, folder), 11},
          {"folder of tables", of_shape(MeshFileShape{"wall_csv/"}, folder), 11},
          {"surfaces", both, 11},
          {"splinters of a file", splintered(folder), 11},
          {"a projectile of a file", shot_with_surface(folder), 11}};
}

Timeline played(const Scene& scene, int steps) {
  Timeline timeline{World(scene)};
  for (int step = 0; step < steps; ++step) {
    if (step == 4) {
      ProjectileBurst shot;
      shot.position = Vec3(-0.3, 0.8, 2);
      shot.speed = 25;
      timeline.fire(shot);
    }
    if (step == 9) {
      Material material = timeline.world().frame().materials[0];
      material.tensile_strength *= 0.5;
      timeline.set_material(0, material);
    }
    timeline.advance();
    if (step == 12) {
      timeline.go_to(3);
      timeline.go_to(timeline.last_step());
    }
  }
  return timeline;
}

Recording through_file(const Recording& recording, const std::filesystem::path& folder) {
  write_recording(recording, folder / "run.tar.zst");
  return read_recording(folder / "run.tar.zst");
}

}  // namespace griffith::testing
