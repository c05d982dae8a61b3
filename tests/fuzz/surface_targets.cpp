#include <cmath>
#include <sstream>

#include "sim/mesh/box_mesh.h"
#include "sim/mesh/mesh_report.h"
#include "sim/mesh/topology.h"
#include "sim/meshing/mesh_surface.h"
#include "sim/splinters/convex_cells.h"
#include "sim/splinters/splinters.h"
#include "tests/fuzz/mutate_bytes.h"
#include "tests/fuzz/mutate_soup.h"
#include "tests/fuzz/small_scenes.h"
#include "tests/fuzz/target.h"
#include "tests/mesh/mesh_invariants.h"
#include "tests/meshing/surfaces.h"

namespace griffith::fuzz {
namespace {

// --- Surfaces in each format ----------------------------------------------------------------------------------------

template <class... Words>
std::string line(const Words&... words) {
  std::ostringstream out;
  ((out << words << ' '), ...) << '\n';
  return out.str();
}

std::string obj_text(const TriangleSurface& surface) {
  std::string text = "o part\n";
  for (const Vec3& p : surface.points) text += line("v", p.x(), p.y(), p.z());
  for (const auto& [a, b, c] : surface.triangles) text += line("f", a + 1, b + 1, c + 1);
  return text;
}

std::string off_text(const TriangleSurface& surface) {
  std::string text = "OFF\n" + line(surface.points.size(), surface.triangles.size(), 0);
  for (const Vec3& p : surface.points) text += line(p.x(), p.y(), p.z());
  for (const auto& [a, b, c] : surface.triangles) text += line(3, a, b, c);
  return text;
}

std::string ply_text(const TriangleSurface& surface) {
  std::string text = "ply\nformat ascii 1.0\n" + line("element vertex", surface.points.size());
  text += "property float x\nproperty float y\nproperty float z\n" + line("element face", surface.triangles.size());
  text += "property list uchar int vertex_indices\nend_header\n";
  for (const Vec3& p : surface.points) text += line(p.x(), p.y(), p.z());
  for (const auto& [a, b, c] : surface.triangles) text += line(3, a, b, c);
  return text;
}

std::string stl_text(const TriangleSurface& surface) {
  std::string text = "solid part\n";
  for (int i = 0; i < std::ssize(surface.triangles); ++i) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const Vec3& p : corners_of(surface, i)) text += line("vertex", p.x(), p.y(), p.z());
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid part\n";
}

template <class T>
void append_bytes(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::string stl_bytes(const TriangleSurface& surface) {
  std::string bytes(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(surface.triangles.size()));
  for (int i = 0; i < std::ssize(surface.triangles); ++i) {
    for (int k = 0; k < 3; ++k) append_bytes(bytes, 0.0f);
    for (const Vec3& corner : corners_of(surface, i))
      for (const double x : corner) append_bytes(bytes, static_cast<float>(x));
    append_bytes(bytes, std::uint16_t{0});
  }
  return bytes;
}

Input surface_input(const TriangleSurface& surface, RandomValues& random) {
  switch (random.index(5)) {
    case 0:
      return {"input.obj", {{"input.obj", obj_text(surface)}}};
    case 1:
      return {"input.off", {{"input.off", off_text(surface)}}};
    case 2:
      return {"input.ply", {{"input.ply", ply_text(surface)}}};
    case 3:
      return {"input.stl", {{"input.stl", stl_text(surface)}}};
    default:
      return {"input.stl", {{"input.stl", stl_bytes(surface)}}};
  }
}

/// Opens holes, turns triangles, moves points through each other.
TriangleSurface mutate_surface(TriangleSurface surface, RandomValues& random) {
  do {
    auto& triangle = surface.triangles[random.index(static_cast<int>(surface.triangles.size()))];
    Vec3& point = surface.points[random.index(static_cast<int>(surface.points.size()))];
    switch (random.index(6)) {
      case 0:
        std::swap(triangle[0], triangle[1]);
        break;
      case 1:
        triangle = surface.triangles.back(), surface.triangles.pop_back();
        break;
      case 2:
        triangle[random.index(3)] = random.index(static_cast<int>(surface.points.size()));
        break;
      case 3:
        point += random.vector(0.5);
        break;
      case 4:
        point *= std::pow(10, random.uniform(-6, 12));
        break;
      default:
        point = Vec3(pick(random, surface.points));
    }
  } while (chance(random, 0.5) && surface.triangles.size() > 1);
  return surface;
}

class SurfaceTarget : public Target {
 public:
  std::string name() const override { return "surface"; }
  int fraction() const override { return 5; }

  Input make(RandomValues& random) const override {
    const TriangleSurface& surface = pick(random, surfaces_);
    const bool odd = chance(random, 0.5);
    Input input = surface_input(odd ? mutate_surface(surface, random) : surface, random);
    if (!odd) input.files[input.entry] = mutate_file(std::move(input.files[input.entry]), random);
    return input;
  }

  Outcome run(const Input& input, const std::filesystem::path& folder) const override {
    TriangleSurface surface = read_surface(folder / input.entry);
    const MeshingOptions options = options_for(input);
    const SurfaceReport report = prepare_surface(surface);
    MeshingSetup setup;
    setup.limits = {2, std::int64_t{2} << 30};  // TetGen never ends with some surfaces
    findings(report);
    if (std::abs(report.volume) > kMaxVolume || report.size() > kMaxSize) return Outcome::too_large;
    TetSoup soup = mesh_surface(std::move(surface), options, setup).soup;
    TetMesh checked;
    prepare(soup, "surface", &checked);
    promise(testing::check_invariants(checked).empty(), "the mesh of a surface is unsound");
    return Outcome::ran;
  }

 private:
  /// The lattice; of some inputs what TetGen makes.
  static constexpr double kMaxVolume = 200, kMaxSize = 40;

  static MeshingOptions options_for(const Input& input) {
    MeshingOptions options;
    const bool small = size_of(input) % 4 == 0;
    options.method = small ? MeshingMethod::automatic : MeshingMethod::volumetric;
    options.element_size = 0.7;
    return options;
  }

  std::vector<TriangleSurface> surfaces_ = {testing::box_surface(Vec3(0, 0, 0), Vec3(2, 1, 1)),
                                            testing::sphere_surface(1, 4), testing::torus_surface(1, 0.5, 6, 4)};
};

// --- Cells of splinters ---------------------------------------------------------------------------------------------

TetMesh unit_box() { return build_mesh(make_box(Vec3(1, 1, 1), Vec3(1, 1, 1), BoxPattern::five_tet)); }

/// Checks that the parts of a tet in different cells are disjoint.
Outcome split_box(const CellPartition& cells) {
  const TetMesh mesh = unit_box();
  const SplinterSet splinters = make_splinters(mesh, cells);
  double volume = 0;
  for (const SplinterPart& part : splinters.parts) volume += part.volume;
  promise(volume >= 0 && volume <= 1 + 1e-3, "splinters hold " + std::to_string(volume) + " times the body's volume");
  return Outcome::ran;
}

class CellsTarget : public Target {
 public:
  std::string name() const override { return "cells"; }
  int fraction() const override { return 5; }

  Input make(RandomValues& random) const override {
    return {"input.obj", {{"input.obj", mutate_file(small_files().at("cells.obj"), random)}}};
  }

  Outcome run(const Input& input, const std::filesystem::path& folder) const override {
    return split_box(read_cells(folder / input.entry, 1));
  }
};

class PointsTarget : public Target {
 public:
  std::string name() const override { return "points"; }
  int fraction() const override { return 60; }

  Input make(RandomValues& random) const override {
    std::string text = chance(random, 0.5) ? "x,y,z\n" : "";
    for (int i = 1 + random.index(20); i > 0; --i) {
      const Vec3 p = chance(random, 0.8) ? random.vector() : Vec3(random.vector(4).array().round() / 2);
      text += line(p.x(), p.y(), p.z());
    }
    if (chance(random, 0.8)) text = mutate_file(std::move(text), random);
    return {"input.xyz", {{"input.xyz", text}}};
  }

  Outcome run(const Input& input, const std::filesystem::path& folder) const override {
    const Eigen::AlignedBox3d bounds(Vec3(Vec3::Constant(-0.5)), Vec3(Vec3::Constant(0.5)));
    return split_box(make_cells(PointSplinters{folder / input.entry, 1}, bounds));
  }
};

}  // namespace

std::unique_ptr<Target> make_surface_target() { return std::make_unique<SurfaceTarget>(); }
std::unique_ptr<Target> make_cells_target() { return std::make_unique<CellsTarget>(); }
std::unique_ptr<Target> make_points_target() { return std::make_unique<PointsTarget>(); }

}  // namespace griffith::fuzz
