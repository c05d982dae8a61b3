#pragma once

#include <functional>

#include "app/render/render_job.h"

namespace griffith::app {

/// Makes the run of a job and passes pictures of microsteps of each step before a picture to the callback, at most
/// job.microsteps of them at equal intervals: for each every camera and view. Each names its time since the first.
/// Needs a current OpenGL context, and memory for the worlds of all moments of a step. Throws InputError as
/// render_job(), and for a step without microsteps.
void render_microsteps(const RenderJob& job, const Scene& scene, bool always_numbered,
                       const std::function<void(RenderedPicture)>& take);

}  // namespace griffith::app
