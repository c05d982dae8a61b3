#pragma once

// Private to sim/contact: the contacts of a group of rigid bodies as its substeps need them.

#include <span>
#include <vector>

#include "sim/contact/rigid_solver.h"
#include "sim/contact/triple.h"
#include "sim/core/parallel.h"

namespace griffith::contact {

/// Motion of a body in a step that contacts change, and its response to them.
struct Motion {
  Triple velocity, spin;
  bool moves = false, is_hinged = false;
  double inverse_mass = 0;
  Symmetric inverse_inertia;
  Triple push_velocity, push_spin;

  void push(const Triple& arm, const Triple& impulse) {
    velocity += inverse_mass * impulse;
    spin += inverse_inertia * cross(arm, impulse);
  }
  void push_out(const Triple& arm, const Triple& impulse) {
    if (!moves || is_hinged) return;
    push_velocity += inverse_mass * impulse;
    push_spin += inverse_inertia * cross(arm, impulse);
  }
  bool is_pushed_out() const {
    return push_velocity.x != 0 || push_velocity.y != 0 || push_velocity.z != 0 || push_spin.x != 0 ||
           push_spin.y != 0 || push_spin.z != 0;
  }
};

/// Returns the motions of bodies as a step begins.
std::vector<Motion> motions_of(std::span<const RigidBody> bodies);

/// Contact as the substeps need it, in the order in which sweeps read it. Impulses are along the block's axes, on a.
struct Point {
  Triple arm_a, arm_b;
  Triple couple, counted;  ///< angular impulse on both by the shift, and the impulse of which it is [N·m·s], [N·s]
  Triple shift;            ///< from arm_a to that at the start, and back from arm_b: see meet() [m]
  double inverse_normal = 0;                 ///< 1 / compliance along the normal [kg]
  double couple_x = 0, couple_y = 0;         ///< compliance of the tangents under a normal impulse [1/kg]
  double xx = 0, xy = 0, yy = 0;             ///< inverse of the tangents' compliance [kg]
  double inverse_largest = 0;                ///< inverse of the largest eigenvalue of that compliance [kg]
  double target = 0;                         ///< target of the separation speed in the present substep [m/s]
  double normal = 0, first = 0, second = 0;  ///< impulse of a substep [N·s]
  double distance = 0, gap = 0;              ///< at the start, in the present substep [m]
  double driven = 0;                         ///< speed of the gap's opening by what contacts do not move [m/s]
  Triple total;                              ///< impulse of the step [N·s]
  Triple force;                              ///< force of the last substep [N]
  double resting = 0, pushed = 0;            ///< overlap that stays, what went of one [m]
  double restitution = 0, approach = 0, fall = 0;
  Triple before, direction;  ///< impulses before the present sweep; the last change [N·s]
  int contact = 0;           ///< index into all
  bool is_mean = false;      ///< as the contact has it
};

/// Contacts of two bodies with the same normal.
struct Block {
  int a = 0, b = 0;
  Triple normal, first, second;
  double friction = 0;
  int begin = 0, end = 0;  ///< range of its points
  bool overlaps = false;   ///< true if the overlap exceeds the one that remains
};

/// Sets the arms of a contact, and the compliances that follow from them.
void set_arms(Point& point, const Block& block, const Triple& arm_a, const Triple& arm_b, const Motion& a,
              const Motion& b);

/// Contacts of a group, those of two bodies together, in the order in which they are solved: downward through a pile,
/// which carries its load at once; in a large group by colors, so that those of one color share no body that contacts
/// move and may be solved side by side.
class RigidRows {
 public:
  /// Impulses start from the forces of the last step, for substeps of `substep` [s].
  RigidRows(std::span<const Motion> motions, std::span<const RigidContact> contacts, const RigidGroup& group,
            double substep);

  std::vector<Block> blocks;
  std::vector<Point> points;  ///< in the order of the blocks

  /// True if nothing is known of the impulses.
  bool is_cold() const;

  template <class Use>
  void for_each_block(Use use) {
    constexpr int kBlocksAtOnce = 64;
    if (colors_.size() == 2) {
      for (Block& block : blocks) use(block);
      return;
    }
    for (std::size_t color = 0; color + 1 < colors_.size(); ++color) {
      const int begin = colors_[color], count = colors_[color + 1] - begin;
      if (count < 2 * kBlocksAtOnce) {
        for (int i = begin; i < begin + count; ++i) use(blocks[i]);
        continue;
      }
      parallel_parts(count, kBlocksAtOnce, [&](int first, int last) {
        for (int i = begin + first; i < begin + last; ++i) use(blocks[i]);
      });
    }
  }

 private:
  void color_blocks(std::span<const Motion> motions);
  void order_by_color(const std::vector<int>& color_of, const std::vector<int>& counts);

  std::vector<int> colors_;  // begins of ranges of blocks, and the end
};

}  // namespace griffith::contact
