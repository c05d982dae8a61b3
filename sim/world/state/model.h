#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "sim/core/error.h"
#include "sim/mesh/tet_mesh.h"
#include "sim/scene/scene.h"
#include "sim/splinters/splinters.h"
#include "sim/world/setup/element_choice.h"

namespace griffith {

/// Constant data of a world. Its copies share it.
struct Model {
  Scene scene;
  std::vector<ElementChoice> element_choices;  ///< per scene body
  std::vector<double> min_edges;               ///< per scene body: shortest edge that remeshing makes [m]
  std::vector<double> extents;  ///< per scene body: longest edge of the box around its largest piece at rest [m]
  std::vector<std::optional<Weakness>> weaknesses;  ///< per scene body, direction in the placed rest space, unit length
  std::vector<std::shared_ptr<const TetSoup>> filled_surfaces;  ///< per scene body, as made; null for other shapes
  std::vector<int> points;  ///< per node that bodies start with: its index in the mesh of their shape, as built or read
  SplinterSet splinters;
  std::vector<std::vector<HullCorner>> splinter_hulls;  ///< per splinter; empty where they are not what touches
  std::vector<InputError> findings;  ///< problems of the scene for the user that do not keep it from running
};

}  // namespace griffith
