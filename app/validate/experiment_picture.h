#pragma once

#include "app/validate/experiment.h"
#include "renderer/image.h"

namespace griffith::app {

/// Returns a picture of an experiment that has one (Experiment::pictured). Needs a current OpenGL context.
render::Image experiment_picture(const Experiment& experiment);

}  // namespace griffith::app
