#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "sim/core/linear_algebra.h"
#include "sim/fracture/node_separation.h"

namespace griffith {

// One table of the quantities of a frame. Views, legends, probes, plots, files and bindings follow from it. A quantity
// is a function of one of these samples, which decides where it has values.

/// State at a node, or its mean over the nodes of a probe.
struct NodeSample {
  Vec3 displacement;  ///< [m]
  Vec3 velocity;      ///< [m/s]
  Vec3 reaction;      ///< force of supports in the last step [N]; of a probe: their sum
  const NodeSeparation& separation;
};

/// State of an element, or its mean over the elements at the nodes of a probe.
struct ElementSample {
  const Mat3& stress;     ///< Cauchy stress, world frame [Pa]
  double energy_density;  ///< elastic energy per volume at rest [J/m³]
};

/// Shape of an element at rest.
struct ShapeSample {
  std::array<Vec3, 4> corners;  ///< [m]
};

/// Face of an element.
struct FaceSample {
  double time;    ///< now [s]
  double opened;  ///< time at which a crack opened it [s]; not a number: none did
};

/// Function of a sample. None: the quantity only distinguishes objects by colors.
using QuantityFunction =
    std::variant<std::monostate, double (*)(const NodeSample&), Vec3 (*)(const NodeSample&),
                 double (*)(const ElementSample&), Vec3 (*)(const ElementSample&), Mat3 (*)(const ElementSample&),
                 double (*)(const ShapeSample&), double (*)(const FaceSample&)>;

/// Computes the same as a function of elements, for many at once.
using StressFunction = void (*)(std::span<const Mat3> stresses, std::span<float> values);

/// Quantity of a frame. Places where it appears follow from its function, unless a flag excludes them.
struct Quantity {
  std::string_view key;      ///< as in a scene file: "von_mises"
  std::string_view label;    ///< as in a menu or a legend: "von Mises stress"
  std::string_view unit;     ///< "Pa"; "-" for a ratio, "" for an id or if the components have their own
  std::string_view meaning;  ///< a phrase for lists and tables
  QuantityFunction function = {};
  std::array<std::string_view, 6> components = {};  ///< names of the components in columns of probes; none for a scalar
  bool in_views = true;                             ///< colors show it: the value, or the length of a vector
  bool in_probes = true;   ///< probes measure it, if it is a function of a NodeSample or an ElementSample
  bool in_files = true;    ///< exported files and bindings have it, if it has values per node or element
  bool is_signed = false;  ///< values below 0 have the opposite meaning of those above
  std::optional<std::array<double, 2>> range = {};  ///< colors always cover it; absent: that of the values
  double noise = 0;                                 ///< least width of the range of colors; 0: 1e-4 of the strength
  StressFunction function_of_many = nullptr;

  bool has_values() const { return !std::holds_alternative<std::monostate>(function); }
};

/// Returns the whole table, in the order of menus.
std::span<const Quantity> quantities();
/// Returns the entry of a key; null if there is none.
const Quantity* find_quantity(std::string_view key);

/// Returns the quantities that colors can show.
std::vector<const Quantity*> view_quantities();
/// Returns the quantities that probes can measure.
std::vector<const Quantity*> probe_quantities();
/// Returns the quantities of exported files and bindings, with values per node or element.
std::vector<const Quantity*> file_quantities();
/// Returns the keys of quantities, to be listed.
std::vector<std::string_view> keys_of(std::span<const Quantity* const> listed);

/// Returns the entry of a key that colors can show; null if there is none.
const Quantity* find_view_quantity(std::string_view key);

}  // namespace griffith
