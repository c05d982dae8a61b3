#include "sim/scene/view_quantity.h"

#include <array>

namespace griffith {

std::span<const ViewQuantity> view_quantities() {
  static constexpr std::array<ViewQuantity, 12> kQuantities = {{
      {"von_mises", "von Mises stress", "Pa"},
      {"max_principal_stress", "largest principal stress", "Pa"},
      {"min_principal_stress", "smallest principal stress", "Pa"},
      {"pressure", "pressure", "Pa"},
      {"margin", "load over resistance", "-"},
      {"separation_eigenvalue", "separation eigenvalue", "N"},
      {"displacement", "displacement", "m"},
      {"speed", "speed", "m/s"},
      {"material", "material", ""},
      {"body", "body", ""},
      {"splinter", "splinter", ""},
      {"texture", "texture coordinates", ""},
  }};
  return kQuantities;
}

std::span<const std::string_view> color_map_names() {
  static constexpr std::array<std::string_view, 3> kNames = {"viridis", "coolwarm", "cividis"};
  return kNames;
}

}  // namespace griffith
