#include "app/shared/scene_world.h"

#include <cmath>
#include <cstdio>

#include "app/shared/expected_mesh.h"
#include "app/shared/progress.h"

namespace griffith::app {
namespace {

constexpr double kManyTets = 4e5, kManySplinters = 5e4;

/// Describes the cost of building so many tetrahedra and splinters on one core of a usual machine; empty if they are
/// few.
std::string size_note(double tets, double splinters) {
  constexpr double kBytesPerTet = 1e3, kBytesPerSplinter = 16e3, kSecondsPerTet = 4e-6, kSecondsPerSplinter = 70e-6;
  if (tets < kManyTets && splinters < kManySplinters) return "";
  const double bytes = tets * kBytesPerTet + splinters * kBytesPerSplinter;
  const double seconds = tets * kSecondsPerTet + splinters * kSecondsPerSplinter;
  char text[240];
  std::snprintf(text, sizeof text,
                "about %.0f thousand tetrahedra and %.0f thousand splinters: building them takes about %.1f GB and "
                "%.0f s (Ctrl+C cancels; larger elements need less)",
                tets / 1e3, splinters / 1e3, bytes / 1e9, std::ceil(seconds));
  return text;
}

}  // namespace

InputError in_file(const std::filesystem::path& scene_file, const InputError& error) {
  if (!error.where().starts_with("#")) return error;
  return InputError(scene_file.string() + error.where(), error.problem(), error.remedy());
}

World make_world(const Scene& scene, const std::filesystem::path& scene_file, const Monitor& monitor) {
  try {
    return World(scene, monitor);
  } catch (const InputError& error) {
    throw in_file(scene_file, error);
  }
}

World make_world(const Scene& scene, const std::filesystem::path& scene_file) {
  StageProgress progress;
  if (const std::string note = size_note(expected_tets(scene), expected_splinters(scene)); !note.empty())
    progress.note(note);
  Monitor monitor;
  monitor.stage = [&](std::string_view stage) { progress.enter(stage); };
  return make_world(scene, scene_file, monitor);
}

}  // namespace griffith::app
