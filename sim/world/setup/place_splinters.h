#pragma once

#include "sim/core/monitor.h"
#include "sim/world/setup/rest_body.h"
#include "sim/world/state/model.h"

namespace griffith {

/// Makes a body's splinters, if it has a pattern for them. Throws InputError for one that cannot be made.
void place_splinters(Model& model, int scene_body, const RestBody& body, const Monitor& monitor);
/// Sets the data common to the splinters of all bodies, after all were made.
void close_splinters(Model& model);

}  // namespace griffith
