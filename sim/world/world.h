#pragma once

#include <memory>
#include <vector>

#include "sim/core/error.h"
#include "sim/core/monitor.h"
#include "sim/scene/grab.h"
#include "sim/scene/push.h"
#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"
#include "sim/world/output/microstep_observer.h"
#include "sim/world/setup/in_memory_meshes.h"
#include "sim/world/state/state_hashes.h"

namespace griffith {

/// Scene in motion. Results depend only on the scene, the shots, grabs, pushes and edits, and the number of steps:
/// never on the clock, the number of threads or the frame rate.
class World {
 public:
  /// Builds meshes and setup. Throws InputError if a mesh or a value of the scene is unusable, and Cancelled if the
  /// monitor, to which long work is reported, requests it.
  explicit World(const Scene& scene, const Monitor& monitor = {});
  /// Builds it with meshes from memory in place of those files.
  World(const Scene& scene, const InMemoryMeshes& meshes, const Monitor& monitor = {});
  ~World();
  /// Copies a world as it is between two steps: both go on alike, to the bit. So a copy is a snapshot to come back to,
  /// or a branch. What never changes is shared.
  World(const World&);
  World& operator=(const World&);
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  /// Advances by the scene's time step.
  void step();
  /// Does the same and shows the microsteps of explicit dynamics to an observer.
  void step(const MicrostepObserver& observer);
  /// Returns a read-only view, valid until the next call that changes the world.
  Frame frame() const;
  /// Returns problems of a scene that still runs: supports, loads and probes that hold nothing, oddities of mesh files.
  /// `where` is a JSON pointer, "#/bodies/0/loads/1/region".
  const std::vector<InputError>& findings() const;

  /// Launches `burst`, its start counted from now. Throws InputError for a shape whose file cannot be used. Returns
  /// what fires the same again, without that file.
  ProjectileBurst fire(const ProjectileBurst& burst);
  /// Pulls a point of material to a target by a spring, in place of the present grab. Wakes its piece, which may deform
  /// and break. Throws InputError if the point does not exist, or if the scene's analysis is static.
  void grab(const Grab& grab);
  /// Moves the target of the grab [m]. Throws InputError if nothing is grabbed.
  void move_grab(const Vec3& target);
  /// Ends the grab, if there is one.
  void release();
  /// Pushes a point of material by a constant force in the next step, whose impulse is given. Wakes its piece, which
  /// may deform and break. Throws InputError if the point does not exist, or if the scene's analysis is static.
  void push(const Push& push);
  /// Sets elastic and fracture properties of the pieces of Scene::bodies[scene_body] while running. Density takes
  /// effect as well: velocities are kept, momentum changes with the mass. Before the first step the body starts as if
  /// made of the material: supported bodies in its equilibrium. Throws InputError, and changes nothing, for a material
  /// with which explicit integration would take too many substeps.
  void set_material(int scene_body, const Material& material);

  /// Returns its memory, without that shared with `beside`, a world with the same past, approximately [bytes].
  std::size_t memory(const World* beside = nullptr) const;

  /// Returns a hash of all positions, velocities and topology: equal bits have equal hashes.
  std::uint64_t state_hash() const;
  /// Hashes of all that is kept from step to step, by kind.
  StateHashes state_hashes() const;

  /// Returns the scene from which it was built.
  const Scene& scene() const;
  /// Returns the original tets that filled the surface of a scene body [m]; null for other shapes.
  const TetSoup* filled_surface(int scene_body) const;

 private:
  struct Impl;
  explicit World(std::unique_ptr<Impl> impl);

  std::unique_ptr<Impl> impl_;
};

}  // namespace griffith
