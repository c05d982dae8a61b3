#include "app/output/open_world.h"

#include <algorithm>

#include "app/output/output.h"
#include "app/shared/scene_world.h"

namespace griffith::app {

void print_warnings(const std::filesystem::path& scene_file, std::span<const InputError> warnings) {
  constexpr std::size_t kMaximum = 20;
  for (const InputError& warning : warnings.first(std::min(warnings.size(), kMaximum)))
    print_error("warning: %s\n", printable(in_file(scene_file, warning).what()).c_str());
  if (warnings.size() > kMaximum) print_error("warning: and %zu more\n", warnings.size() - kMaximum);
}

World open_world(const Scene& scene, const std::filesystem::path& scene_file) {
  World world = make_world(scene, scene_file);
  print_warnings(scene_file, world.findings());
  return world;
}

}  // namespace griffith::app
