#include <cmath>

#include "tests/validation/validation_case.h"

namespace griffith::validation {

bool Row::passes() const {
  switch (check) {
    case Check::near:
      return std::abs(error()) <= tolerance;
    case Check::at_most:
      return got <= expected;
    case Check::at_least:
      return got >= expected;
  }
  return false;
}

Row near(const MeshLabel& mesh, const std::string& quantity, double expected, double got, double tolerance) {
  return {mesh, quantity, expected, got, tolerance, Check::near};
}
Row at_most(const MeshLabel& mesh, const std::string& quantity, double limit, double got) {
  return {mesh, quantity, limit, got, 0, Check::at_most};
}
Row at_least(const MeshLabel& mesh, const std::string& quantity, double limit, double got) {
  return {mesh, quantity, limit, got, 0, Check::at_least};
}

std::span<const Case> cases() {
  static constexpr Case kCases[] = {
      {"AffineDeformation", "Affine deformation",
       "A block under a uniform deformation gradient. Every tet has the stress of that gradient, and no inner "
       "node has a force.",
       affine_deformation},
      {"RigidMotion", "Rigid motion", "A block in twenty rotations and displacements. There is no strain and no force.",
       rigid_motion},
      {"DifferenceQuotients", "Forces and stiffness against difference quotients",
       "A single tet. Its forces are the gradient of its energy, its stiffness is that of its forces, and "
       "forces rotate with the element.",
       difference_quotients},
      {"CantileverTipLoad", "Cantilever 10:1:1 with a load at its tip",
       "The tip deflects by PL³/3EI + PL/(κGA), κ = 5/6 (Timoshenko). Linear tets are too stiff and give the "
       "expected fraction, with n cells through the thickness. ν = 0.3. BCC has more nodes and is compared at "
       "equal nodes: it is always better than Kuhn, and better than five-tet from n = 4.",
       cantilever_tip_load},
      {"CantileverGravity", "Cantilever 10:1:1 under gravity",
       "The tip deflects by qL⁴/8EI + qL²/(2κGA). The expected fractions are those of the load at the tip.",
       cantilever_gravity},
      {"Locking", "Locking toward incompressibility",
       "The fraction of the cantilever's deflection as ν → 0.5. Linear tets lock: each fraction is below the "
       "one before.",
       locking},
      {"BarInTension", "Bar in tension",
       "A free bar pulled at its ends, unrotated and rotated. The separation stress s equals the bar's stress "
       "at every node away from the ends.",
       bar_in_tension},
      {"ThreePointBending", "Three-point bending",
       "A beam with a span of 10 depths. The worst node lies on the bottom near midspan and opens along the "
       "beam. s is compared with beam theory there, where the load itself reduces it by some 2 %, and halfway "
       "to the bearings. There are n cells through the depth.",
       three_point_bending},
      {"PlateWithHole", "Plate with a hole, d/W = 0.1",
       "The largest s over the stress far from the hole, with n elements around a quadrant of it. The closed "
       "form is 3.03. There is one element through the thickness, which matches those at the hole.",
       plate_with_hole},
      {"BrazilianDisc", "Brazilian disc",
       "A disc compressed along a diameter by two line loads. The stress in its middle is 2P/(πDt) across the "
       "load. There are n elements across the diameter. Expected fractions are those of five-tet. With 4 "
       "across, the figure depends on the pattern alone.",
       brazilian_disc},
      {"LongitudinalWave", "Longitudinal wave",
       "A free bar, n cells long and 2 across, ν = 0, with a sudden push on its end, in stable explicit steps. "
       "Measured is the time when the other end moves at a tenth of its final velocity, over L/√(E/ρ). The "
       "mesh's dispersion sends the foot of the front ahead.",
       longitudinal_wave},
      {"FreeFall", "Free fall",
       "After steps of h the block is at x₀ + v₀t − ½gt(t+h), without stress, for 120 steps and any stiffness.",
       free_fall},
      {"ModeDecay", "A mode under implicit Euler, and the stable explicit step",
       "Implicit Euler multiplies a mode's energy by 1/(1 + ω²h²) per step. The explicit step is stable below "
       "2/ω.",
       mode_decay},
      {"LongRun", "Energy and momentum over a long run",
       "An undamped block flies, rotates and vibrates. In 10,000 explicit steps of half the stable length its "
       "energy oscillates but does not drift. In 1,000 implicit steps it never gains more than the rounding of "
       "finite rotations. Momenta are constant.",
       long_run},
  };
  return kCases;
}

}  // namespace griffith::validation
