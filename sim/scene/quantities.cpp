#include "sim/scene/quantities.h"

#include <algorithm>
#include <limits>

#include "sim/elasticity/principal_stress.h"
#include "sim/meshing/mesh_quality.h"

namespace griffith {
namespace {

/// Computes the largest principal stresses, or with a sign of −1 the smallest, of four elements at once [Pa].
template <int sign>
void extreme_stresses(std::span<const Mat3> stresses, std::span<float> values) {
  constexpr std::size_t kLanes = 4;
  for (std::size_t i = 0; i < values.size(); i += kLanes) {
    const std::size_t count = std::min(kLanes, values.size() - i);
    std::array<Mat3, kLanes> signed_stresses;
    for (std::size_t lane = 0; lane < kLanes; ++lane)  // extra lanes repeat the last element
      signed_stresses[lane] = sign * stresses[i + std::min(lane, count - 1)];
    const std::array<double, kLanes> found = largest_principal_values(signed_stresses);
    for (std::size_t lane = 0; lane < count; ++lane)
      values[i + lane] = signed_stresses[lane].allFinite() ? static_cast<float>(sign * found[lane])
                                                           : std::numeric_limits<float>::quiet_NaN();
  }
}

constexpr std::array<std::string_view, 6> kVector = {"x", "y", "z"}, kTensor = {"xx", "yy", "zz", "xy", "yz", "zx"};

const Quantity kQuantities[] = {
    {.key = "utilization",
     .label = "utilization",
     .unit = "-",
     .meaning = "load over resistance; breaks above 1",
     .function = [](const NodeSample& node) { return node.separation.utilization; },
     .range = {{0, 1}}},
    {.key = "von_mises",
     .label = "von Mises stress",
     .unit = "Pa",
     .meaning = "von Mises stress of the Cauchy stress",
     .function = [](const ElementSample& element) { return von_mises_stress(element.stress); }},
    {.key = "max_principal_stress",
     .label = "largest principal stress",
     .unit = "Pa",
     .meaning = "largest principal value of the Cauchy stress, tension positive",
     .function = [](const ElementSample& element) { return principal_stresses(element.stress)[0]; },
     .is_signed = true,
     .function_of_many = extreme_stresses<1>},
    {.key = "mid_principal_stress",
     .label = "middle principal stress",
     .unit = "Pa",
     .meaning = "middle principal value of the Cauchy stress",
     .function = [](const ElementSample& element) { return principal_stresses(element.stress)[1]; },
     .is_signed = true},
    {.key = "min_principal_stress",
     .label = "smallest principal stress",
     .unit = "Pa",
     .meaning = "smallest principal value of the Cauchy stress",
     .function = [](const ElementSample& element) { return principal_stresses(element.stress)[2]; },
     .is_signed = true,
     .function_of_many = extreme_stresses<-1>},
    {.key = "pressure",
     .label = "pressure",
     .unit = "Pa",
     .meaning = "mean compressive stress",
     .function = [](const ElementSample& element) { return -element.stress.trace() / 3; },
     .is_signed = true},
    {.key = "separation_stress",
     .label = "separation stress",
     .unit = "Pa",
     .meaning = "load that the criterion \"strength\" compares with the resistance",
     .function = [](const NodeSample& node) { return node.separation.stress; }},
    {.key = "separation_eigenvalue",
     .label = "separation eigenvalue",
     .unit = "N",
     .meaning = "load across the candidate plane",
     .function = [](const NodeSample& node) { return node.separation.eigenvalue; },
     .noise = 1e-3},
    {.key = "strain_energy",
     .label = "strain energy density",
     .unit = "J/m³",
     .meaning = "elastic energy per volume at rest",
     .function = [](const ElementSample& element) { return element.energy_density; },
     .noise = 1e-3},
    {.key = "displacement",
     .label = "displacement",
     .unit = "m",
     .meaning = "displacement since the start; colors show its length",
     .function = [](const NodeSample& node) { return node.displacement; },
     .components = kVector,
     .noise = 1e-6},
    {.key = "speed",
     .label = "speed",
     .unit = "m/s",
     .meaning = "length of the velocity",
     .function = [](const NodeSample& node) { return node.velocity.norm(); },
     .noise = 1e-3},
    {.key = "element_quality",
     .label = "element quality",
     .unit = "-",
     .meaning = "reciprocal of the aspect ratio at rest: 1 for a regular tetrahedron, 0 for a flat one",
     .function = [](const ShapeSample& shape) { return 1 / aspect_ratio(shape.corners); },
     .range = {{0, 1}}},
    {.key = "crack_age",
     .label = "age of crack faces",
     .unit = "s",
     .meaning = "time since a crack opened the face; other faces are gray",
     .function = [](const FaceSample& face) { return face.time - face.opened; },
     .noise = 1e-3},
    {.key = "plain", .label = "plain", .unit = "", .meaning = "one color"},
    {.key = "material", .label = "material", .unit = "", .meaning = "natural colors of materials"},
    {.key = "body", .label = "body", .unit = "", .meaning = "a color for each piece"},
    {.key = "tet", .label = "element", .unit = "", .meaning = "a color for each element"},
    {.key = "splinter", .label = "splinter", .unit = "", .meaning = "a color for each splinter"},
    {.key = "texture", .label = "texture coordinates", .unit = "", .meaning = "a checkerboard in texture coordinates"},
    {.key = "velocity",
     .label = "velocity",
     .unit = "m/s",
     .meaning = "velocity",
     .function = [](const NodeSample& node) { return node.velocity; },
     .components = kVector,
     .in_views = false},
    {.key = "reaction",
     .label = "reaction",
     .unit = "N",
     .meaning = "force of supports in the last step; of a probe: the sum over its nodes",
     .function = [](const NodeSample& node) { return node.reaction; },
     .components = kVector,
     .in_views = false},
    {.key = "stress",
     .label = "stress",
     .unit = "Pa",
     .meaning = "Cauchy stress in the world's axes",
     .function = [](const ElementSample& element) { return element.stress; },
     .components = kTensor,
     .in_views = false},
    {.key = "principal_stress",
     .label = "principal stresses",
     .unit = "Pa",
     .meaning = "principal values of the Cauchy stress, the largest first",
     .function = [](const ElementSample& element) { return principal_stresses(element.stress); },
     .components = {"1", "2", "3"},
     .in_views = false,
     .in_files = false},
    {.key = "separation",
     .label = "separation",
     .unit = "",
     .meaning = "utilization, separation stress and separation eigenvalue",
     .function =
         [](const NodeSample& node) {
           return Vec3(node.separation.utilization, node.separation.stress, node.separation.eigenvalue);
         },
     .components = {"utilization [-]", "stress [Pa]", "eigenvalue [N]"},
     .in_views = false,
     .in_files = false},
    {.key = "resistance",
     .label = "resistance",
     .unit = "Pa or N",
     .meaning = "load at which the candidate plane opens; a force with the criterion \"separation_force\"",
     .function = [](const NodeSample& node) { return node.separation.resistance; },
     .in_views = false,
     .in_probes = false},
    {.key = "separation_direction",
     .label = "separation direction",
     .unit = "-",
     .meaning = "unit normal of the candidate plane",
     .function = [](const NodeSample& node) { return node.separation.direction; },
     .components = kVector,
     .in_views = false,
     .in_probes = false},
};

std::vector<const Quantity*> all_with(bool (*matches)(const Quantity& quantity)) {
  std::vector<const Quantity*> found;
  for (const Quantity& quantity : kQuantities)
    if (matches(quantity)) found.push_back(&quantity);
  return found;
}

/// True for values of nodes or elements, rather than of faces.
bool has_values_inside(const Quantity& quantity) {
  return quantity.has_values() && !std::holds_alternative<double (*)(const FaceSample&)>(quantity.function);
}

/// True if probes can evaluate a quantity: from the means of nodes or elements.
bool has_means(const Quantity& quantity) {
  return std::visit(
      []<class Function>(Function) {
        return std::is_invocable_v<Function, const NodeSample&> || std::is_invocable_v<Function, const ElementSample&>;
      },
      quantity.function);
}

}  // namespace

std::span<const Quantity> quantities() { return kQuantities; }

const Quantity* find_quantity(std::string_view key) {
  const auto found = std::ranges::find(kQuantities, key, &Quantity::key);
  return found == std::end(kQuantities) ? nullptr : &*found;
}

std::vector<const Quantity*> view_quantities() {
  return all_with([](const Quantity& quantity) { return quantity.in_views; });
}

std::vector<const Quantity*> probe_quantities() {
  return all_with([](const Quantity& quantity) { return quantity.in_probes && has_means(quantity); });
}

std::vector<const Quantity*> file_quantities() {
  return all_with([](const Quantity& quantity) { return quantity.in_files && has_values_inside(quantity); });
}

std::vector<std::string_view> keys_of(std::span<const Quantity* const> listed) {
  std::vector<std::string_view> keys;
  for (const Quantity* quantity : listed) keys.push_back(quantity->key);
  return keys;
}

const Quantity* find_view_quantity(std::string_view key) {
  const Quantity* found = find_quantity(key);
  return found && found->in_views ? found : nullptr;
}

}  // namespace griffith
