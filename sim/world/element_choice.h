#pragma once

#include <string>

#include "sim/scene/scene.h"

namespace griffith {

/// The elements of a scene body, and why.
struct ElementChoice {
  ElementOrder order = ElementOrder::linear;  ///< never ElementOrder::automatic
  bool automatic = false;                     ///< the scene left the choice
  int layers = 0;                             ///< across the thinnest part, of a choice (layers_across())
  std::string reason;                         ///< of a choice: "1 lies across its thinnest part"
};

/// "linear, since remeshing needs them", for a body of any choice.
std::string text_of(const ElementChoice& choice);

}  // namespace griffith
