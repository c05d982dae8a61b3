#pragma once

#include "sim/scene/scene_fields.h"
#include "sim/scene/world_input.h"

// Table of all fields of inputs to a world, as scene_fields.h has those of a scene.

namespace griffith {

template <class Archive>
void describe(Archive& archive, MaterialChange& change) {
  archive.field("scene_body", change.scene_body, between(0, 10000), "Index of the body in the scene");
  archive.field("material", change.material, MaterialChoice{}, "Material from then on");
}

template <class Archive>
void describe(Archive& archive, GrabSpring& spring) {
  archive.field("frequency", spring.frequency, between(0.01, 100, "Hz"),
                "Frequency of the piece on the spring; lower where time steps are too long for it");
  archive.field("damping_ratio", spring.damping_ratio, between(0, 10, "-"), "Damping over critical damping");
  archive.field("strength", spring.strength, between(0.01, 1e6, "-"),
                "Greatest force, in weights of the piece under standard gravity");
}

template <class Archive>
void describe(Archive& archive, Grab& grab) {
  archive.field("tet", grab.tet, between(0, 1e9), "Index of the tet that holds the point");
  archive.field("weights", grab.weights, between(0, 1, "-"), "Barycentric weights of its corners 1 to 3");
  archive.field("target", grab.target, kPlace, "End of the spring");
  archive.field("spring", grab.spring, Parts{}, "Spring, relative to the mass of the piece");
}

template <class Archive>
void describe(Archive& archive, GrabMove& move) {
  archive.field("target", move.target, kPlace, "New end of the spring");
}

template <class Archive>
void describe(Archive&, GrabRelease&) {}

template <class Archive>
void describe(Archive& archive, Push& push) {
  archive.field("tet", push.tet, between(0, 1e9), "Index of the tet that holds the point");
  archive.field("weights", push.weights, between(0, 1, "-"), "Barycentric weights of its corners 1 to 3");
  archive.field("impulse", push.impulse, between(-1e9, 1e9, "N·s"), "Impulse, given in the next step");
}

template <class Archive>
void describe(Archive& archive, WorldInput& input) {
  archive.field("step", input.step, between(0, kMaxSteps), "Number of steps before it");
  archive.template alternative<ProjectileBurst>("fire", input.action, Parts{},
                                                "Burst with a start relative to that time");
  archive.template alternative<MaterialChange>("set_material", input.action, Parts{}, "Change of material");
  archive.template alternative<Grab>("grab", input.action, Parts{}, "Grab of a point by a spring");
  archive.template alternative<GrabMove>("move_grab", input.action, Parts{}, "New target of the grab");
  archive.template alternative<GrabRelease>("release", input.action, Parts{}, "End of the grab");
  archive.template alternative<Push>("push", input.action, Parts{}, "Impulse on a point");
}

}  // namespace griffith
