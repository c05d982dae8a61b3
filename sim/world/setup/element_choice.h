#pragma once

#include <string>

#include "sim/scene/scene.h"

namespace griffith {

/// Element order of a scene body, and its reason.
struct ElementChoice {
  ElementOrder order = ElementOrder::linear;  ///< never ElementOrder::automatic
  bool automatic = false;                     ///< the scene left the choice
  int layers = 0;                             ///< across the thinnest part, of an automatic choice (layers_across())
  std::string reason;                         ///< reason of an automatic choice: "1 lies across its thinnest part"
};

/// Returns a text such as "quadratic, since 1 lies across its thinnest part".
std::string text_of(const ElementChoice& choice);

}  // namespace griffith
