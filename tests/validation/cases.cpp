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
       "A block under a uniform deformation gradient: every tet has the stress that the gradient gives, and no node "
       "inside "
       "a force.",
       affine_deformation},
      {"RigidMotion", "Rigid motion", "A block turned twenty ways and moved: no strain, no force.", rigid_motion},
      {"DifferenceQuotients", "Forces and stiffness against difference quotients",
       "A single tet: its forces are the slope of its energy, its stiffness that of its forces, and forces turn with "
       "the "
       "element.",
       difference_quotients},
      {"CantileverTipLoad", "Cantilever 10:1:1 with a load at its tip",
       "The tip sinks by PL³/3EI + PL/(κGA), κ = 5/6 (Timoshenko); linear tets are too stiff and give the expected "
       "share "
       "with n cells through the thickness. ν = 0.3. BCC, which has more nodes, is compared at equal nodes: it passes "
       "Kuhn "
       "always and five-tet from n = 4.",
       cantilever_tip_load},
      {"CantileverGravity", "Cantilever 10:1:1 under gravity",
       "The tip sinks by qL⁴/8EI + qL²/(2κGA); expected are the shares of the load at the tip.", cantilever_gravity},
      {"Locking", "Locking toward incompressibility",
       "The cantilever's share of its deflection while ν → 0.5: linear tets lock, each share below the one before.",
       locking},
      {"BarInTension", "Bar in tension",
       "A free bar pulled at its ends, straight and turned: the stress s that pulls a node apart is the bar's stress "
       "at "
       "every node off the ends.",
       bar_in_tension},
      {"ThreePointBending", "Three-point bending",
       "A beam, span 10 depths: the worst node lies on the bottom near midspan and opens along the beam. s is compared "
       "with "
       "beam theory there, where the load itself takes off some 2 %, and half-way to the bearings; n cells through the "
       "depth.",
       three_point_bending},
      {"PlateWithHole", "Plate with a hole, d/W = 0.1",
       "The largest s over the stress far away, n elements round a quadrant of the hole; closed form 3.03. One element"
       " through a thickness that matches those at the hole.",
       plate_with_hole},
      {"BrazilianDisc", "Brazilian disc",
       "A disc pressed along a diameter by two line loads: in its middle 2P/(πDt) across the load; n elements across "
       "the "
       "diameter; expected shares are those of five-tet. With 4 across the figure depends on the pattern alone.",
       brazilian_disc},
      {"LongitudinalWave", "Longitudinal wave",
       "A free bar, n cells long and 2 across, ν = 0, its end suddenly pushed, in stable explicit steps: when the "
       "other end "
       "moves at a tenth of its final velocity, over L/√(E/ρ). The mesh's dispersion sends the foot of the front "
       "ahead.",
       longitudinal_wave},
      {"FreeFall", "Free fall",
       "After steps of h the block is at x₀ + v₀t − ½gt(t+h), without stress, for 120 steps and any stiffness.",
       free_fall},
      {"ModeDecay", "A mode under implicit Euler, and the stable explicit step",
       "Implicit Euler multiplies a mode's energy by 1/(1 + ω²h²) a step; the explicit step is stable below 2/ω.",
       mode_decay},
      {"LongRun", "Energy and momentum over a long run",
       "An undamped block flies, turns and vibrates. 10,000 explicit steps of half the stable length: its energy "
       "swings but "
       "does not drift; 1,000 implicit ones: it never gains more than turning by finite angles rounds off. Momenta "
       "stay.",
       long_run},
  };
  return kCases;
}

}  // namespace griffith::validation
