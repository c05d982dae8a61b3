#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "sim/explicit/explicit_bodies.h"
#include "sim/explicit/obstacle.h"
#include "sim/explicit/sharp_edge.h"
#include "sim/fracture/cohesion.h"
#include "sim/geometry/point_grid.h"

namespace griffith::explicit_dynamics {

/// Face of the bodies' surface, opposite a corner of a tet.
struct SurfaceSide {
  int slot = 0, face = 0;
};

/// Contact properties of an explicit body.
struct SurfaceLaw {
  int family = 0;  ///< >= 0; pieces of one family touch only where cracks separated them
  double friction = 0.6;
};

/// Two sides of an opened crack, with coincident corners at rest.
struct CrackSides {
  int first_slot = 0, second_slot = 0;
  std::array<int, 3> first_corners{}, second_corners{};
  std::array<Bond, 3> bonds{};  ///< by corner; forces and openings as they act in the bodies
};

/// Nodes of both sides in the bodies.
struct NodesOfSides {
  std::array<int, 3> first{}, second{};
};

/// Contacts in the microsteps: obstacles with the surface of the bodies, explicit bodies with each other, and the
/// sides of closing cracks. Impulses act on lumped masses where surfaces overlap and approach. The rebound follows from
/// the elasticity of the bodies.
class MicrostepContacts {
 public:
  /// Contact with an impulse, for reports.
  struct RecordedImpact {
    int node = 0;         ///< explicit node
    int obstacle = -1;    ///< index of the obstacle, or -1: another explicit node
    Vec3 place, normal;   ///< normal points from the bodies to the other
    Vec3 impulse;         ///< impulse on the bodies [N·s]
    double approach = 0;  ///< speed of approach [m/s]
    double depth = 0;     ///< overlap before it [m]
  };

  /// `surfaces`: per explicit body; `element_size`: mean edge length, which scales the search for overlaps [m].
  MicrostepContacts(const ExplicitBodies& bodies, std::span<const SurfaceSide> surface,
                    std::span<const CrackSides> cracks, std::vector<Obstacle> obstacles,
                    std::vector<SurfaceLaw> surfaces, double element_size);

  /// Resolves contacts between the forces and the motion of a microstep of `dt`: finds overlaps, applies impulses, then
  /// moves the obstacles. Impacts faster than `min_speed` are recorded.
  void resolve(ExplicitBodies& bodies, double dt, double min_speed);
  /// Moves obstacles without contacts to their present positions.
  void catch_up();
  /// Adds the faces that a crack opened to the surface. Returns the index of the crack.
  int open(const ExplicitBodies& bodies, const CrackSides& sides);
  /// Bonds a corner of a crack.
  void bond(int crack, int corner, const Bond& bond) {
    cracks_[crack].sides.bonds[corner] = bond;
    lists_bonds_ = false;
  }
  /// Ties the copies of edges along cracks, after cracks have opened and before the next motion.
  void tie_edges(ExplicitBodies& bodies);
  std::span<Obstacle> obstacles() { return obstacles_; }
  std::span<const Obstacle> obstacles() const { return obstacles_; }
  int crack_count() const { return static_cast<int>(cracks_.size()); }
  const CrackSides& crack(int index) const { return cracks_[index].sides; }
  std::span<const RecordedImpact> recorded_impacts() const { return recorded_impacts_; }
  /// True if a bond has opened by a further sixteenth of its critical opening, or has broken, in the last microstep.
  bool have_bonds_opened() const { return have_bonds_opened_; }
  /// Returns the work of search and impulses so far, in microseconds of a typical core, counted and not timed.
  double work() const { return work_; }

  /// Returns the energy dissipated by impulses in microsteps of `dt` [s] [J]. Each impulse counts at the mean velocity
  /// of its microstep, which ends with the next forces, so the bodies must have these.
  double lost(const ExplicitBodies& bodies, double dt);
  /// Returns the energy that bonds have taken so far [J].
  double fractured() const { return fractured_; }

 private:
  /// Face of the surface. Points deeper behind it than half its tet do not count as behind it [m].
  struct Side : SurfaceSide {
    double deepest = 0;
  };
  /// Point of a face, or a node, with its contact.
  struct Touch {
    std::array<int, 3> nodes{};
    std::array<double, 3> weights{1, 0, 0};
    int count = 3;      ///< number of nodes in use: of a face, an edge or a single node; none for the ground
    int obstacle = -1;  ///< index of the obstacle, or -1
    std::array<int, 2> other_nodes{};  ///< without an obstacle: a node or the ends of an edge of another body
    std::array<double, 2> other_weights{1, 0};
    int other_count = 0;
    Vec3 place = Vec3::Zero(), normal = Vec3::UnitY();  ///< normal points from the bodies to the other
    double depth = 0;
    double pressure = 0;           ///< normal impulse in this microstep [N·s]
    Vec3 friction = Vec3::Zero();  ///< its friction, on the bodies [N·s]
    double reverted = 0;           ///< normal impulses times the time of the last motion that they reverted [N·s²]
    double approach = 0;           ///< largest speed of approach [m/s]
    double deepest = 0;            ///< largest overlap [m]
  };
  /// Touch, and the index of its candidate.
  struct Found {
    std::size_t candidate = 0;
    Touch touch;
  };
  /// Pair without contact until all motion has covered this distance in total [m].
  struct Watched {
    double clear_until = 0;
  };
  struct WatchedSide : Watched {
    Side side;
  };
  /// Sample of a convex part near a side.
  struct SampleAndSide : Watched {
    int part = 0, sample = 0;
    Side side;
  };
  struct PartAndNode : Watched {
    int part = 0, node = 0;
  };
  /// Edge of the bodies' surface between two sides, convex in the undeformed bodies.
  struct SurfaceEdge {
    std::array<int, 2> nodes{};
    std::array<std::array<int, 3>, 2> sides{};  ///< nodes of both, counterclockwise seen from outside
  };
  struct EdgePair : Watched {
    int first = 0, second = 0;  ///< edges of the bodies
  };
  /// Edge of a convex part near one of the bodies.
  struct PartAndEdge : Watched {
    int part = 0, of_part = 0, edge = 0;
  };
  /// Side with its present bounding box.
  struct BoxedSide {
    Eigen::AlignedBox3d box;
    Side side;
  };
  /// Surface with a grid of the boxes' centers.
  struct BoxedSurface {
    std::vector<BoxedSide> sides;
    PointGrid grid;                          ///< grid of `sides`
    Vec3 largest;                            ///< half of the largest box size along each axis [m]
    std::vector<Eigen::AlignedBox3d> edges;  ///< boxes of the sharp edges
  };
  /// Candidates of contact with an obstacle: sides for a sphere, nodes and samples for any other.
  struct Candidates {
    std::vector<WatchedSide> sides;
    std::vector<PartAndNode> nodes;
    std::vector<SampleAndSide> samples;  ///< samples by part and index
    std::vector<PartAndEdge> edges;

    bool empty() const { return sides.empty() && nodes.empty() && samples.empty() && edges.empty(); }
  };
  /// Point of an obstacle near the ground.
  struct GroundedPoint {
    int obstacle = 0;
    Vec3 sample = Vec3::Zero();  ///< in its own frame; unused for a sphere
  };
  struct NodeAndSide : Watched {
    int node = 0;
    Side side;
  };
  struct WatchedCrack : Watched {
    CrackSides sides;
  };
  struct CornerOfCrack {
    int crack = 0, corner = 0;
  };
  /// Two nodes that bonds hold together, and these bonds.
  struct BondedNodes {
    int first = 0, second = 0;
    int first_corner = 0, count = 0;  ///< range in bonded_corners_
    Bond whole;                       ///< all of them as one
  };
  /// Effect of impulses on a node in the last microstep.
  struct Pushed {
    int node = 0;
    Vec3 change = Vec3::Zero();        ///< change of its velocity [m/s]
    Vec3 displacement = Vec3::Zero();  ///< displacement of the node [m]
  };

  void add_side(const ExplicitBodies& bodies, const SurfaceSide& side);
  const SurfaceLaw& surface_at(const ExplicitBodies& bodies, int node) const;
  int family_of(const ExplicitBodies& bodies, const SurfaceSide& side) const;
  bool is_clear(const Watched& watched) const { return travelled_ < watched.clear_until; }
  void record_gap(Watched& watched, double gap) const;
  void list_candidates(const ExplicitBodies& bodies, double displacement);
  /// Returns an upper bound of the closing speed of any two nodes or obstacles [m/s].
  double closing_speed(const ExplicitBodies& bodies) const;
  BoxedSurface boxed_surface(const ExplicitBodies& bodies) const;
  std::vector<BoxedSide> sides_near(const ExplicitBodies& bodies, const Obstacle& obstacle,
                                    const BoxedSurface& surface) const;
  void list_near_obstacle(const ExplicitBodies& bodies, const Obstacle& obstacle, const BoxedSurface& surface,
                          Candidates& candidates) const;
  void list_near_part(const ExplicitBodies& bodies, const Obstacle& obstacle, int part,
                      std::span<const BoxedSide> sides, std::span<const int> nodes, Candidates& candidates) const;
  std::vector<BoxedSide> sides_near_others(const ExplicitBodies& bodies, std::span<const BoxedSide> surface) const;
  void list_pairs(const ExplicitBodies& bodies, std::span<const BoxedSide> surface);
  void find_edges(const ExplicitBodies& bodies);
  SharpEdge sharp_edge(const ExplicitBodies& bodies, const SurfaceEdge& edge) const;
  bool has_families() const;
  std::vector<Eigen::AlignedBox3d> edge_boxes(const ExplicitBodies& bodies) const;
  void list_edges_near(const ExplicitBodies& bodies, const Obstacle& obstacle,
                       std::span<const Eigen::AlignedBox3d> boxes, Candidates& candidates) const;
  void list_edge_pairs(const ExplicitBodies& bodies, std::span<const Eigen::AlignedBox3d> boxes);
  Touch edge_touch(const SurfaceEdge& edge, const SharpEdge& present, const EdgeContact& contact) const;
  void touch_edges(const ExplicitBodies& bodies, int obstacle);
  void touch_edge_pairs(const ExplicitBodies& bodies);
  void find_touches(const ExplicitBodies& bodies);
  std::size_t candidate_count() const;
  void touch_sphere(const ExplicitBodies& bodies, int obstacle);
  void touch_convex(const ExplicitBodies& bodies, int obstacle);
  void touch_inside(const ExplicitBodies& bodies, int obstacle);
  void drop_clamps(const ExplicitBodies& bodies, std::size_t first);
  void touch_bodies(const ExplicitBodies& bodies);
  template <class Candidate, class PlaceOf>
  void find_behind(const ExplicitBodies& bodies, std::vector<Candidate>& candidates, PlaceOf place_of);
  template <class Candidate, class PlaceOf>
  void find_behind(const ExplicitBodies& bodies, std::span<Candidate> candidates, std::size_t first, PlaceOf place_of,
                   std::vector<Found>& found) const;
  void touch_nearest(const ExplicitBodies& bodies, std::span<const Found> found);
  /// True if the first of two sides rather touches a point behind both: the one behind which it is less deep. If depths
  /// are equal, as at an edge, the one that it passes through.
  bool is_nearer(const ExplicitBodies& bodies, const Touch& touch, const Touch& other) const;
  Vec3 approach_of(const ExplicitBodies& bodies, const Touch& touch) const;
  double mobility_of(const ExplicitBodies& bodies, const Touch& touch, const Vec3& direction) const;
  double friction_of(const ExplicitBodies& bodies, const Touch& touch) const;
  /// Applies an impulse to the bodies, and its opposite to the other [N·s].
  void act(ExplicitBodies& bodies, const Touch& touch, const Vec3& impulse);
  /// Reverts the part of the last motion that `impulse` would have prevented, for `time` [s] of it.
  void take_back(ExplicitBodies& bodies, const Touch& touch, const Vec3& impulse, double time);
  Vec3 change_of_friction(const ExplicitBodies& bodies, const Touch& touch, const Vec3& velocity,
                          double pressure) const;
  bool push(ExplicitBodies& bodies, Touch& touch, double dt);
  double act_within_energy(ExplicitBodies& bodies, const Touch& touch, const Vec3& impulse, const Vec3& velocity,
                           double time);
  void record_impacts(double min_speed);
  const Obstacle& ground() const;
  void list_grounded();
  void touch_ground();
  bool stop_at_ground(ExplicitBodies& bodies, double dt);
  void list_bonds(const ExplicitBodies& bodies);
  void hold_cracks(ExplicitBodies& bodies, double dt);
  Bond& bond_at(const CornerOfCrack& at) { return cracks_[at.crack].sides.bonds[at.corner]; }
  void hold(ExplicitBodies& bodies, BondedNodes& bonded, const Vec3& direction, double opening, double dt);
  void close_cracks(ExplicitBodies& bodies);
  void push_apart(ExplicitBodies& bodies, const NodesOfSides& sides, const Vec3& normal, const Vec3& weights);
  Pushed& pushed(const ExplicitBodies& bodies, int node);
  void push_node(ExplicitBodies& bodies, int node, const Vec3& impulse);
  void shift_node(ExplicitBodies& bodies, int node, const Vec3& displacement);
  void record_pushed(const ExplicitBodies& bodies);
  void settle_pushed(const ExplicitBodies& bodies, double dt);

  std::vector<Side> surface_;
  std::vector<SurfaceEdge> edges_;  ///< edges of the first `sides_with_edges_` sides; none if no others meet them
  std::size_t sides_with_edges_ = 0;
  std::vector<WatchedCrack> cracks_;
  std::vector<Obstacle> obstacles_;
  std::vector<SurfaceLaw> surfaces_;    ///< per explicit body
  std::vector<Candidates> candidates_;  ///< per obstacle
  std::vector<NodeAndSide> pairs_;      ///< nodes near sides of other bodies, by node
  std::vector<EdgePair> edge_pairs_;    ///< edges near those of other bodies
  std::vector<GroundedPoint> grounded_;
  std::vector<Touch> grounded_touches_;  ///< per point near the ground
  std::vector<Touch> touches_;
  std::vector<Found> found_;
  std::vector<int> order_;  ///< order of touches, the deepest first
  std::vector<RecordedImpact> recorded_impacts_;
  std::vector<Pushed> pushed_;
  std::vector<int> pushed_at_;                 ///< per node: index into pushed_, or -1
  std::vector<BondedNodes> bonds_;             ///< those that hold, as far as `lists_bonds_`
  std::vector<CornerOfCrack> bonded_corners_;  ///< corners of the bonds, also of those that have broken since
  bool lists_bonds_ = false;
  bool have_bonds_opened_ = false;
  double lost_ = 0, fractured_ = 0, work_ = 0;
  double last_dt_ = 0;  ///< length of the last microstep [s]
  double element_size_, margin_ = 0;
  double travelled_ = 0;      ///< bound on the total approach of any two objects [m]
  double listed_until_ = -1;  ///< distance up to which the candidates are complete [m]
};

}  // namespace griffith::explicit_dynamics
