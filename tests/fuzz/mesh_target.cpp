#include "sim/mesh/mesh_report.h"
#include "sim/mesh/read_mesh.h"
#include "sim/mesh/topology.h"
#include "sim/mesh/write_mesh.h"
#include "tests/fuzz/mutate_bytes.h"
#include "tests/fuzz/mutate_soup.h"
#include "tests/fuzz/target.h"
#include "tests/fuzz/world_checks.h"
#include "tests/mesh/cell_files.h"
#include "tests/mesh/sample_files.h"

namespace griffith::fuzz {
namespace {

/// "a.1.node" becomes "input.node", "folder/verts.csv" "input/verts.csv".
std::string input_name(const std::string& sample) {
  const std::size_t slash = sample.find('/');
  if (slash != std::string::npos || sample == "folder")
    return "input" + (slash == std::string::npos ? "" : sample.substr(slash));
  return "input" + sample.substr(sample.rfind('.'));
}

Input input_of(const testing::SampleFile& sample) {
  Input input{input_name(sample.path), {}};
  for (const auto& [name, content] : sample.files) input.files[input_name(name)] = content;
  return input;
}

/// A weak body that falls on the ground: what is odd in its mesh is cracked along.
Scene scene_of(const std::filesystem::path& path, const MeshReport& report) {
  Scene scene;
  BodyDescription body;
  body.shape = MeshFileShape{path};
  body.velocity = Vec3(1, -5, 0);
  body.material.young_modulus = 1e8;
  body.material.tensile_strength = 1e4;
  scene.bodies = {body};
  scene.ground->height = report.minimum.y();
  scene.simulation.step_budget = 2;
  return scene;
}

class MeshTarget : public Target {
 public:
  std::string name() const override { return "mesh"; }
  int fraction() const override { return 470; }

  Input make(RandomValues& random) const override {
    const bool odd = chance(random, 0.5);
    Input input = chance(random, 0.2) ? cells(odd, random) : tets(odd, random);
    if (odd && chance(random, 0.8)) return input;
    auto file = input.files.begin();
    std::advance(file, random.index(static_cast<int>(input.files.size())));
    file->second = mutate_file(std::move(file->second), random);
    if (chance(random, 0.01)) input.files.erase(file);
    return input;
  }

  Outcome run(const Input& input, const std::filesystem::path& folder) const override {
    const std::filesystem::path path = folder / input.entry;
    CellReport cells;
    TetSoup soup = read_mesh(path, &cells);
    for (const std::int64_t skipped : cells.skipped) promise(skipped >= 0, "a negative number of cells was skipped");
    findings(cells);
    if (soup.tets.size() > kMaxTets) return Outcome::too_large;
    TetMesh mesh;
    const MeshReport report = prepare(soup, "mesh", &mesh);
    findings(report);
    promise(report.volume > 0, "a mesh without volume is called good");
    write_and_read(soup, folder);
    run_world(scene_of(path, report), kMaxSteps, report.slivers > 0);
    return Outcome::ran;
  }

 private:
  Input tets(bool odd, RandomValues& random) const {
    const TetSoup& soup = pick(random, soups_);
    return input_of(pick(random, testing::sample_files(odd ? mutate_soup(soup, random) : soup)));
  }

  /// Hexahedra, prisms, pyramids and tets, odd ones folded.
  static Input cells(bool odd, RandomValues& random) {
    const int n = 1 + random.index(2), seed = random.index(1000);
    return input_of(pick(random, testing::cell_files(testing::mixed_block(n, odd ? 0.8 : 0.2, seed))));
  }

  static void write_and_read(const TetSoup& soup, const std::filesystem::path& folder) {
    write_gmsh(folder / "again.msh", soup);
    const TetSoup again = read_mesh(folder / "again.msh");
    promise(again.points == soup.points && again.tets == soup.tets, "written and read, it is another mesh");
  }

  static constexpr std::size_t kMaxTets = 2000;
  static constexpr int kMaxSteps = 2;
  std::vector<TetSoup> soups_ = small_soups();
};

}  // namespace

std::unique_ptr<Target> make_mesh_target() { return std::make_unique<MeshTarget>(); }

}  // namespace griffith::fuzz
