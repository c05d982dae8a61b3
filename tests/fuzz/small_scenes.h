#pragma once

#include <vector>

#include "sim/scene/scene.h"
#include "tests/fuzz/input.h"
#include "tests/fuzz/vocabulary.h"

namespace griffith::fuzz {

/// The shipped scenes, and others with any of the fields that there are, of few bodies in few tets each, what flies
/// close to what it hits. Files that they name are among small_files().
std::vector<Json> small_scenes();

/// A mesh, a surface, points and cells of some hundred bytes each, for scenes to name.
const std::map<std::string, std::string>& small_files();

/// About how many tets and splinters a world of the scene has, times the substeps that each explicit step takes.
double work_of(const Scene& scene);

/// Limits what a user may ask for and wait for.
Scene made_quick(Scene scene);

}  // namespace griffith::fuzz
