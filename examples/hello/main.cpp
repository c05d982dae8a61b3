// A brick wall made from arrays, and a ball shot at it.
#include <griffith/world.h>

#include <cstdio>

using namespace griffith;

/// Makes a box of 6 × 6 × 2 cells of half a meter, each cut into six tetrahedra around its diagonal.
TetSoup make_wall() {
  TetSoup wall;
  for (int z = 0; z <= 2; ++z)
    for (int y = 0; y <= 6; ++y)
      for (int x = 0; x <= 6; ++x) wall.points.push_back({0.5 * x - 1.5, 0.5 * y, 0.5 * z});
  constexpr int kX = 1, kY = 7, kZ = 49;  // index steps to the next point along each axis
  constexpr int kWays[6][2] = {{kX, kY}, {kY, kX}, {kX, kZ}, {kZ, kX}, {kY, kZ}, {kZ, kY}};
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x)
        for (const auto& [first, second] : kWays) {
          const int corner = x * kX + y * kY + z * kZ;
          wall.tets.push_back({corner, corner + first, corner + first + second, corner + kX + kY + kZ});
        }
  return wall;
}

int main() try {
  BodyDescription wall;
  wall.shape = MeshFileShape{"wall"};  // name of a mesh in memory, or of a file
  wall.material.tensile_strength = 60e3;
  wall.material.fracture_toughness = 180e3;
  wall.supports = {{HalfSpaceRegion{Vec3::Zero(), -Vec3::UnitY()}}};  // its base: all points at y <= 0
  Scene scene;
  scene.bodies = {wall};
  World world(scene, {{"wall", make_wall()}});
  world.fire({.position = {0.2, 1.6, 5}, .speed = 40, .mass = 25});

  for (int step = 0; step < 100; ++step) world.step();

  const Frame frame = world.frame();
  for (const BodyView& piece : frame.bodies)
    std::printf("%8.1f kg at (%6.3f, %6.3f, %6.3f) m\n", piece.mass, piece.center_of_mass.x(), piece.center_of_mass.y(),
                piece.center_of_mass.z());
  std::printf("%zu pieces after %.2f s, state %016llx\n", frame.bodies.size(), frame.time,
              static_cast<unsigned long long>(world.state_hash()));
} catch (const InputError& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
