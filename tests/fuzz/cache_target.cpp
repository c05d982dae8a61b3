#include "sim/core/hash_bytes.h"
#include "sim/core/temporary_folder.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "sim/meshing/mesh_cache.h"
#include "sim/meshing/mesh_surface.h"
#include "tests/fuzz/mutate_bytes.h"
#include "tests/fuzz/mutate_soup.h"
#include "tests/fuzz/target.h"
#include "tests/meshing/surfaces.h"

namespace griffith::fuzz {
namespace {

/// Damages an entry, and signs it again most of the time: else every damage would be found by its sum.
std::string mutate_entry(const std::string& entry, RandomValues& random) {
  const std::size_t sum = entry.find('\n') + 1, content = sum + sizeof(std::uint64_t);
  if (chance(random, 0.1)) return mutate_bytes(entry, random);
  const std::string damaged = mutate_bytes(entry.substr(content), random);
  const std::uint64_t hash = hash_bytes(damaged);
  return entry.substr(0, sum) + std::string(reinterpret_cast<const char*>(&hash), sizeof hash) + damaged;
}

/// A folder of meshes that somebody else may write to.
class CacheTarget : public Target {
 public:
  CacheTarget() { prepare_surface(surface_); }

  std::string name() const override { return "cache"; }
  int fraction() const override { return 100; }

  Input make(RandomValues& random) const override {
    const TemporaryFolder folder;
    FilledSurface filled;
    filled.soup = make_box(Vec3(2, 1, 1), Vec3(1, 1, 1), BoxPattern::five_tet);
    const bool odd = chance(random, 0.4);
    if (odd) filled.soup = mutate_soup(std::move(filled.soup), random);
    if (chance(random, 0.3)) filled.refusal = "the surface is open";
    write_cache_entry(folder.path() / "entry", filled);
    const std::string entry = read_file(folder.path() / "entry");
    return {"input.tets", {{"input.tets", odd ? entry : mutate_entry(entry, random)}}};
  }

  Outcome run(const Input& input, const std::filesystem::path& folder) const override {
    MeshingSetup setup;
    setup.cache = folder;
    std::filesystem::rename(folder / input.entry, cache_entry(folder, surface_, options_));
    SurfaceMesh mesh = mesh_surface(surface_, options_, setup);
    if (mesh.soup.tets.size() > kMaxTets) return Outcome::too_large;
    prepare(mesh.soup, "cached mesh");
    return mesh.from_cache ? Outcome::ran : Outcome::refused;
  }

 private:
  static constexpr std::size_t kMaxTets = 2000;
  TriangleSurface surface_ = testing::box_surface(Vec3(0, 0, 0), Vec3(2, 1, 1));
  MeshingOptions options_ = {.method = MeshingMethod::volumetric, .element_size = 1};
};

}  // namespace

std::unique_ptr<Target> make_cache_target() { return std::make_unique<CacheTarget>(); }

}  // namespace griffith::fuzz
