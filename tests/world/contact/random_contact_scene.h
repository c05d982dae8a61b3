#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "sim/scene/scene.h"

namespace griffith::testing {

/// A scene of bodies in contact, and what is to become of it.
struct RandomContactScene {
  Scene scene;
  std::string kind;            ///< kind of scene: "heap", "stack", "slope", "press", "thrown", "shot"
  double size = 1;             ///< approximate size of its bodies [m]
  double duration = 2;         ///< simulated time [s]
  bool comes_to_rest = false;  ///< everything must be asleep at the end
};

/// Draws scenes of bodies that lie, fall, slide, press and strike: the same number, the same scene.
class RandomContactMaker {
 public:
  explicit RandomContactMaker(unsigned seed) : random_(seed) {}

  RandomContactScene make() {
    made_.size = logarithmic(0.01, 10);
    Scene& scene = made_.scene;
    scene.simulation.time_step = 1.0 / pick({30, 60, 60, 120, 250});
    scene.ground->friction = chance(0.1) ? 0 : uniform(0.2, 1);
    scene.ground->restitution = uniform(0, 0.6);
    using Making = void (RandomContactMaker::*)();
    constexpr Making kMakings[] = {&RandomContactMaker::heap,  &RandomContactMaker::stack,  &RandomContactMaker::slope,
                                   &RandomContactMaker::press, &RandomContactMaker::thrown, &RandomContactMaker::shot};
    (this->*kMakings[count(0, 5)])();
    stiffen();
    // Falls, flights and slides at 2 √(g size) last up to 14 √(size/g); the rest is for explicit dynamics and tilting
    // to end.
    if (made_.comes_to_rest) made_.duration = 5 + 22 * std::sqrt(made_.size / 9.81);
    scene.name = made_.kind;
    return made_;
  }

 private:
  double uniform(double least, double most) { return std::uniform_real_distribution(least, most)(random_); }
  double logarithmic(double least, double most) { return least * std::pow(most / least, uniform(0, 1)); }
  int count(int least, int most) { return std::uniform_int_distribution(least, most)(random_); }
  bool chance(double probability) { return uniform(0, 1) < probability; }
  double pick(std::initializer_list<double> list) { return list.begin()[count(0, static_cast<int>(list.size()) - 1)]; }
  Vec3 direction() { return Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)).normalized(); }

  /// One of the library, of another weight, unbreakable or with the strain of Green now and then.
  Material material() {
    const auto presets = material_presets();
    Material made = presets[count(0, static_cast<int>(presets.size()) - 1)].material;
    if (chance(0.3)) made.density *= logarithmic(0.01, 100);
    if (chance(0.3)) made.tensile_strength = made.fracture_toughness = 1e13;
    if (chance(0.2)) made.element_model = ElementModel::green_strain;
    if (chance(0.3)) made.friction = uniform(0.2, 1);
    if (!made_.scene.ground->friction) made.friction = 0;
    return made;
  }

  /// Gives what could not carry the weight of such bodies the stiffness to do so: elements of small strains turn inside
  /// out under loads of their modulus.
  void stiffen() {
    double density = 0;
    for (const BodyDescription& body : made_.scene.bodies) density = std::max(density, body.material.density);
    const double least = 100 * density * 9.81 * made_.size;
    for (BodyDescription& body : made_.scene.bodies)
      body.material.young_modulus = std::max(body.material.young_modulus, least);
  }

  /// A shape that fits into a cube of this edge.
  Shape shape(double edge) {
    const double cell = edge / count(1, 3);
    switch (count(0, 5)) {
      case 0:
        return SphereShape{edge / 2, edge / 3};
      case 1:
        return CylinderShape{edge * uniform(0.1, 0.4), edge * uniform(0.3, 0.8), Vec2::Constant(cell)};
      case 2:
        return BoxShape{edge * Vec3(1, uniform(0.05, 0.2), 1), Vec3::Constant(cell), BoxPattern::five_tet};
      case 3:
        return BoxShape{edge * Vec3(1, 0.15, 0.15), Vec3::Constant(cell), BoxPattern::five_tet};
      case 4:
        return PlateWithHoleShape{edge * Vec3(1, 1, 0.1), 0.2 * edge, Vec2::Constant(edge / 4)};
      default:
        return BoxShape{edge * Vec3(uniform(0.3, 1), uniform(0.3, 1), uniform(0.3, 1)), Vec3::Constant(cell),
                        BoxPattern::five_tet};
    }
  }

  BodyDescription& add(const Shape& shape, const Vec3& position) {
    BodyDescription& body = made_.scene.bodies.emplace_back();
    body.name = "body " + std::to_string(made_.scene.bodies.size());
    body.shape = shape;
    body.position = position;
    body.material = material();
    return body;
  }

  BodyDescription& add_box(const Vec3& size, const Vec3& position) {
    return add(BoxShape{size, Vec3::Constant(size.maxCoeff() / count(1, 3)), BoxPattern::five_tet}, position);
  }

  /// Bodies that do not touch, in layers above the ground.
  void scatter(int bodies) {
    for (int i = 0; i < bodies; ++i) {
      // The cube of the shape turns within a sphere round it.
      const double edge = made_.size * uniform(0.3, 1), room = 1.75 * made_.size;
      BodyDescription& body = add(shape(edge), room * Vec3(i % 2 - 0.5, i / 4 + 0.5, i / 2 % 2 - 0.5));
      body.rotation_degrees = 180 * Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1));
      if (chance(0.5)) body.angular_velocity = uniform(0, 3) * std::sqrt(9.81 / made_.size) * direction();
    }
  }

  bool has_friction() const { return made_.scene.ground->friction > 0; }

  void heap() {
    made_.kind = "heap";
    scatter(count(2, 8));
    made_.comes_to_rest = has_friction();
  }

  /// Boxes that stand on each other and side by side.
  void stack() {
    made_.kind = "stack";
    double height = 0;
    for (int level = count(1, 5); level > 0; --level) {
      const double thickness = made_.size * uniform(0.1, 0.6), width = made_.size * uniform(0.5, 1);
      const int columns = count(1, 2);
      for (int column = 0; column < columns; ++column)
        add_box(Vec3(width, thickness, width / columns),
                Vec3(0, height + thickness / 2, width / columns * (column + (1 - columns) / 2.0)));
      height += thickness;
    }
    made_.comes_to_rest = true;
  }

  /// Boxes on a slope: gravity leans instead of the ground.
  void slope() {
    made_.kind = "slope";
    const double angle = uniform(5, 50) * std::numbers::pi / 180;
    made_.scene.gravity = 9.81 * Vec3(std::sin(angle), -std::cos(angle), 0);
    const Vec3 size = made_.size * Vec3(1, uniform(0.1, 0.6), uniform(0.3, 1));
    add_box(size, Vec3(0, size.y() / 2, 0));
    if (chance(0.5)) add_box(0.5 * size, Vec3(0, 1.25 * size.y(), 0));
  }

  /// A driven body comes down on one that lies on the ground, or pushes it along.
  void press() {
    made_.kind = "press";
    const Vec3 size = made_.size * Vec3(uniform(0.5, 1), uniform(0.3, 1), uniform(0.5, 1));
    add_box(size, Vec3(0, size.y() / 2, 0));
    const bool from_above = chance(0.5);
    const Vec3 way = from_above ? Vec3(0, -1, 0) : Vec3(1, 0, 0);
    const Vec3 apart = from_above ? size : Vec3(1.02 * size);
    BodyDescription& driven = add_box(size, Vec3(0, size.y() / 2, 0) - way.cwiseProduct(apart));
    Support& support = driven.supports.emplace_back();
    support.region = HalfSpaceRegion{-0.5 * size.cwiseProduct(way), -way};
    support.kind = SupportKind::prescribed;
    // Pressed bodies yield by some percent; pushed ones slide away.
    support.velocity = made_.size * (from_above ? uniform(1e-3, 0.02) : uniform(0.01, 0.5)) * way;
    support.stop = uniform(0.3, 1);
    made_.duration = 1.5;
  }

  void thrown() {
    made_.kind = "thrown";
    scatter(count(1, 4));
    for (BodyDescription& body : made_.scene.bodies)
      body.velocity = uniform(0, 2) * std::sqrt(9.81 * made_.size) * direction();
    made_.comes_to_rest = has_friction();
  }

  void shot() {
    stack();
    made_.kind = "shot";
    ProjectileBurst& shot = made_.scene.projectiles.emplace_back();
    shot.radius = made_.size * uniform(0.05, 0.2);
    shot.position = made_.size * Vec3(uniform(-0.3, 0.3), 0.3, 3);
    shot.speed = uniform(1, 10) * std::sqrt(9.81 * made_.size);
    shot.density = logarithmic(500, 8000);
    made_.comes_to_rest = false;
  }

  std::mt19937 random_;
  RandomContactScene made_;
};

}  // namespace griffith::testing
