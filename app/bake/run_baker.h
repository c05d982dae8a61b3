#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "app/bake/bake.h"
#include "app/bake/mesh_history.h"
#include "app/output/export_pieces.h"
#include "app/picture/shards.h"
#include "sim/scene/scene.h"
#include "sim/world/output/frame.h"

namespace griffith::app {

/// Bakes a run: follows its frames and tracks the pieces of the last one back to the first.
class RunBaker {
 public:
  /// `start`: the world's first frame. `scene`: of the world; must outlive this. Throws InputError if a surface cannot
  /// be read.
  RunBaker(const Frame& start, const Scene& scene);

  /// Adds a frame to be baked, later than all before.
  void follow(const Frame& frame);
  /// Returns the bake of all followed frames. `last`: the frame that was followed last. `deformed`: with deformed
  /// points.
  Bake finish(const Frame& last, bool deformed = false);

 private:
  std::vector<PieceSurface> open_surfaces_at(const Frame& last, std::span<const Vec3> positions) const;
  void find_holes(const Frame& last);
  std::vector<PieceSurface> surfaces_at(const Frame& last, std::span<const Vec3> positions) const;
  void add_pieces(Bake& bake, const Frame& last, const MeshHistory& history, std::span<const BodyId> pieces,
                  std::span<const std::string> stems) const;
  void add_deformed_points(Bake& bake, const Frame& last, const MeshHistory& history,
                           std::span<const BodyId> pieces) const;
  void add_projectiles(Bake& bake, const Frame& last, const std::string& stem, int material) const;

  const Scene& scene_;
  Shards shards_;
  std::vector<double> strength_factors_;               ///< per node of the start
  std::vector<std::array<TetId, 4>> first_neighbors_;  ///< per tet of the start
  std::vector<MeshState> meshes_;                      ///< mesh of the start, then those of the baked frames
  std::vector<double> times_;
  std::vector<std::vector<std::array<int, 3>>>
      holes_;                                   ///< per body of the last frame: triangles that close its surface
  double opened_before_ = 0;                    ///< time of the last crack before the first baked frame [s]
  std::vector<std::vector<Pose>> projectiles_;  ///< per baked frame
};

}  // namespace griffith::app
