#pragma once

#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/fuzz/choice.h"
#include "tests/fuzz/input.h"

namespace griffith::fuzz {

/// Outcome of an input without failure.
enum class Outcome { refused, too_large, ran };

/// The program did with an input what it promises never to do.
class BrokenPromise : public std::runtime_error {
 public:
  using runtime_error::runtime_error;
};

inline void promise(bool holds, const std::string& otherwise) {
  if (!holds) throw BrokenPromise(otherwise);
}

/// A part of the program that reads what others wrote.
class Target {
 public:
  virtual ~Target() = default;
  virtual std::string name() const = 0;
  /// Returns the number of inputs for this target in 1,000 for all.
  virtual int fraction() const = 0;
  /// A damaged, odd or extreme input; the same for the same random values.
  virtual Input make(RandomValues& random) const = 0;
  /// Reads the input, whose files are in `folder`, and uses what was read. Throws BrokenPromise, and InputError where
  /// the input is refused as it should be.
  virtual Outcome run(const Input& input, const std::filesystem::path& folder) const = 0;
};

std::unique_ptr<Target> make_scene_target();
std::unique_ptr<Target> make_mesh_target();
std::unique_ptr<Target> make_surface_target();
std::unique_ptr<Target> make_cells_target();
std::unique_ptr<Target> make_points_target();
std::unique_ptr<Target> make_cache_target();
std::unique_ptr<Target> make_recording_target();
std::unique_ptr<Target> make_jobs_target();
std::unique_ptr<Target> make_suite_target();
std::unique_ptr<Target> make_sweep_target();
std::unique_ptr<Target> make_script_target();
std::unique_ptr<Target> make_command_target();

}  // namespace griffith::fuzz
