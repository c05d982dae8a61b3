#pragma once

#include <filesystem>
#include <string>

#include "sim/scene/scene.h"

namespace griffith::app {

struct Outcome {
  int code = -1;       ///< exit code, or 128 + signal
  std::string output;  ///< stdout and stderr together
};

/// Runs the real program through the shell. `before` stands before it: another program to run it under.
Outcome run_program(const std::string& arguments, const std::string& before = "");

/// An empty folder of the running test's own.
std::filesystem::path test_folder();

/// Writes text into a file of the test's folder.
std::filesystem::path test_file(const std::string& name, const std::string& text);

/// Makes the scene's first body one that is filled from a surface of the test's folder, in elements of half a meter.
void fill_surface(Scene& scene, const std::string& file);

/// A small brick wall, held at its foot, about to be hit.
Scene small_wall();
/// Its scene file.
std::filesystem::path small_wall_file();

}  // namespace griffith::app
