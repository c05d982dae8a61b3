#pragma once

#include <Eigen/Geometry>
#include <array>
#include <span>
#include <vector>

#include "sim/geometry/point_grid.h"
#include "sim/shock/obstacle.h"
#include "sim/shock/solid.h"

namespace griffith::shock {

/// A face of the solid's surface: that opposite a corner of a tet.
struct SurfaceSide {
  int slot = 0, face = 0;
};

/// How a body of the solid meets others.
struct SurfaceLaw {
  int family = 0;  ///< pieces of one family touch where cracks parted them alone
  double friction = 0.6;
};

/// Two sides of an opened crack, corner by corner in the same places at rest.
struct CrackSides {
  int first_slot = 0, second_slot = 0;
  std::array<int, 3> first_corners{}, second_corners{};
};

/// Their nodes in the solid.
struct NodesOfSides {
  std::array<int, 3> first{}, second{};
};

/// What pushes in the microsteps: obstacles against the surface of the solid, bodies of the solid against each other,
/// and the sides of cracks that close. Impulses act on lumped masses where surfaces overlap and approach; elastic
/// bodies rebound by themselves.
class Impacts {
 public:
  /// A contact that pushed, for those who ask.
  struct Blow {
    int node = 0;         ///< of the solid
    int obstacle = -1;    ///< index, or -1: another node of the solid
    Vec3 place, normal;   ///< normal: from the solid to the other
    Vec3 impulse;         ///< on the solid [N·s]
    double approach = 0;  ///< [m/s]
  };

  /// `surfaces`: per body of the solid; `element_size`: mean edge length, for which overlaps are looked for [m].
  Impacts(const Solid& solid, std::span<const SurfaceSide> surface, std::span<const CrackSides> cracks,
          std::vector<Obstacle> obstacles, std::vector<SurfaceLaw> surfaces, double element_size);

  /// Between the forces and the motion of a microstep of `dt`: finds what overlaps and pushes it, then moves the
  /// obstacles. Blows faster than `min_speed` are noted.
  void resolve(Solid& solid, double dt, double min_speed);
  /// Moves obstacles with nothing near to where they are by now.
  void catch_up();
  /// Faces that a crack opened: what else is there may touch them from now on.
  void open(const Solid& solid, const CrackSides& sides);

  std::span<Obstacle> obstacles() { return obstacles_; }
  std::span<const Blow> blows() const { return blows_; }
  /// What finding and pushing has taken so far, in microseconds of a usual core: counted, not timed.
  double work() const { return work_; }

  /// What the pushes took in microsteps of `dt` [s] [J], each at the mean velocity of its microstep, which ends with
  /// the next one's forces: those the solid has to know.
  double lost(const Solid& solid, double dt);

 private:
  /// A face of the surface. What lies deeper behind it than half the tet there is not behind it [m].
  struct Side : SurfaceSide {
    double deepest = 0;
  };
  /// A point of a face, or a node, and what it meets.
  struct Touch {
    std::array<int, 3> nodes{};
    std::array<double, 3> weights{1, 0, 0};
    int count = 3;                                      ///< of nodes in use: a face or a single node
    int obstacle = -1;                                  ///< index, or
    int other_node = -1;                                ///< a node of another body
    Vec3 place = Vec3::Zero(), normal = Vec3::UnitY();  ///< normal: from the solid to the other
    double depth = 0;
  };
  /// A touch, and the index of what it was found of.
  struct Found {
    std::size_t candidate = 0;
    Touch touch;
  };
  /// Things that may touch, but not before everything has travelled so far in all [m].
  struct Watched {
    double clear_until = 0;
  };
  struct WatchedSide : Watched {
    Side side;
  };
  /// A sample of a convex part near a side.
  struct SampleAndSide : Watched {
    int part = 0, sample = 0;
    Side side;
  };
  struct PartAndNode : Watched {
    int part = 0, node = 0;
  };
  /// A side and what is round it now.
  struct BoxedSide {
    Eigen::AlignedBox3d box;
    Side side;
  };
  /// The surface, and its boxes by their centres.
  struct BoxedSurface {
    std::vector<BoxedSide> sides;
    PointGrid grid;  ///< of `sides`
    Vec3 largest;    ///< half the sizes of the largest box, along each axis [m]
  };
  /// What of the surface may touch an obstacle: sides of it a sphere, nodes and samples anything else.
  struct Candidates {
    std::vector<WatchedSide> sides;
    std::vector<PartAndNode> nodes;
    std::vector<SampleAndSide> samples;  ///< by part and sample

    bool empty() const { return sides.empty() && nodes.empty() && samples.empty(); }
  };
  struct NodeAndSide : Watched {
    int node = 0;
    Side side;
  };
  struct WatchedCrack : Watched {
    CrackSides sides;
  };
  /// What pushes did to a node in the last microstep.
  struct Pushed {
    int node = 0;
    Vec3 change = Vec3::Zero();        ///< of its velocity [m/s]
    Vec3 displacement = Vec3::Zero();  ///< that it was shifted [m]
  };

  void add_side(const Solid& solid, const SurfaceSide& side);
  const SurfaceLaw& surface_at(const Solid& solid, int node) const;
  int family_of(const Solid& solid, const SurfaceSide& side) const;
  bool is_clear(const Watched& watched) const { return travelled_ < watched.clear_until; }
  void record_gap(Watched& watched, double gap) const;
  void list_candidates(const Solid& solid, double displacement);
  /// How fast any two of all nodes and obstacles come nearer to each other, at most [m/s].
  double closing_speed(const Solid& solid) const;
  BoxedSurface boxed_surface(const Solid& solid) const;
  std::vector<BoxedSide> sides_near(const Obstacle& obstacle, const BoxedSurface& surface) const;
  void list_near_obstacle(const Solid& solid, const Obstacle& obstacle, const BoxedSurface& surface,
                          Candidates& candidates) const;
  void list_near_part(const Solid& solid, const Obstacle& obstacle, int part, std::span<const BoxedSide> sides,
                      std::span<const int> nodes, Candidates& candidates) const;
  std::vector<BoxedSide> sides_near_others(const Solid& solid, std::span<const BoxedSide> surface) const;
  void list_pairs(const Solid& solid, std::span<const BoxedSide> surface);
  void find_touches(const Solid& solid);
  std::size_t candidate_count() const;
  void touch_sphere(const Solid& solid, int obstacle);
  void touch_convex(const Solid& solid, int obstacle);
  void touch_inside(const Solid& solid, int obstacle);
  void drop_clamps(const Solid& solid, std::size_t first);
  void touch_bodies(const Solid& solid);
  template <class Candidate, class PlaceOf>
  void find_behind(const Solid& solid, std::vector<Candidate>& candidates, PlaceOf place_of);
  template <class Candidate, class PlaceOf>
  void find_behind(const Solid& solid, std::span<Candidate> candidates, std::size_t first, PlaceOf place_of,
                   std::vector<Found>& found) const;
  void touch_nearest(const Solid& solid, std::span<const Found> found);
  /// Whether what is behind two sides is rather touched by the first: by the one behind which it lies less deep; where
  /// that is the same, as at an edge, by the one that it comes through.
  bool is_nearer(const Solid& solid, const Touch& touch, const Touch& other) const;
  Vec3 approach_of(const Solid& solid, const Touch& touch) const;
  double mobility_of(const Solid& solid, const Touch& touch, const Vec3& direction) const;
  double friction_of(const Solid& solid, const Touch& touch) const;
  /// An impulse on the solid, and its opposite on the other [N·s].
  void act(Solid& solid, const Touch& touch, const Vec3& impulse);
  /// Takes back the part of the last motion that `impulse` would have prevented, for `time` [s] of it.
  void take_back(Solid& solid, const Touch& touch, const Vec3& impulse, double time);
  bool push(Solid& solid, Touch& touch, double dt, double min_speed);
  void close_cracks(Solid& solid);
  void push_apart(Solid& solid, const NodesOfSides& sides, const Vec3& normal, const Vec3& weights);
  Pushed& pushed(const Solid& solid, int node);
  void push_node(Solid& solid, int node, const Vec3& impulse);
  void shift_node(Solid& solid, int node, const Vec3& displacement);
  void record_pushed(const Solid& solid);
  void settle_pushed(const Solid& solid, double dt);

  std::vector<Side> surface_;
  std::vector<WatchedCrack> cracks_;
  std::vector<Obstacle> obstacles_;
  std::vector<SurfaceLaw> surfaces_;    ///< per body of the solid
  std::vector<Candidates> candidates_;  ///< per obstacle
  std::vector<NodeAndSide> pairs_;      ///< nodes near sides of other bodies, by node
  std::vector<Touch> touches_;
  std::vector<Found> found_;
  std::vector<int> order_;  ///< of touches, the deepest first
  std::vector<Blow> blows_;
  std::vector<Pushed> pushed_;
  std::vector<int> pushed_at_;  ///< per node: index into pushed_, or -1
  double lost_ = 0, work_ = 0;
  double element_size_, margin_ = 0;
  double travelled_ = 0;      ///< bound on how much nearer any two things can have come [m]
  double listed_until_ = -1;  ///< candidates are complete up to there [m]
};

}  // namespace griffith::shock
