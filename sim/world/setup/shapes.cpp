#include "sim/world/setup/shapes.h"

#include "sim/core/file_path.h"
#include "sim/mesh/box_mesh.h"
#include "sim/mesh/read_mesh.h"
#include "sim/mesh/shapes.h"
#include "sim/meshing/mesh_cache.h"
#include "sim/meshing/mesh_surface.h"

namespace griffith {
namespace {

struct Maker {
  const std::filesystem::path& folder;
  std::vector<std::string>* known;  ///< about the file; null: nobody asks
  const Monitor& monitor;

  TetSoup operator()(const BoxShape& box) const { return make_box(box.size, box.element_size, box.pattern); }
  TetSoup operator()(const CylinderShape& cylinder) const {
    return make_cylinder(cylinder.radius, cylinder.length, cylinder.element_size, cylinder.pattern);
  }
  TetSoup operator()(const DiscShape& disc) const {
    return make_cylinder(disc.radius, disc.thickness, disc.element_size, disc.pattern);
  }
  TetSoup operator()(const SphereShape& sphere) const {
    return make_sphere(sphere.radius, sphere.element_size, sphere.pattern);
  }
  TetSoup operator()(const PlateWithHoleShape& plate) const {
    return make_plate_with_hole(plate.size, plate.hole_radius, plate.element_size, plate.pattern);
  }
  TetSoup operator()(const NotchedBeamShape& beam) const {
    return make_notched_beam(beam.size, beam.notch_depth, beam.element_size, beam.pattern);
  }
  TetSoup operator()(const MeshFileShape& file) const {
    CellReport report;
    TetSoup soup = read_mesh(file_path(folder, file.path), &report);
    if (known != nullptr) *known = findings(report);
    for (Vec3& point : soup.points) point *= file.scale;
    return soup;
  }
  TetSoup operator()(const SurfaceShape& shape) const {
    const std::filesystem::path path = file_path(folder, shape.path);
    MeshingSetup setup;
    setup.name = path.string();
    setup.cache = default_mesh_cache();
    setup.monitor = monitor;
    SurfaceMesh mesh = mesh_surface(read_surface(path, shape.scale, setup.monitor), shape.meshing, setup);
    if (known != nullptr) *known = std::move(mesh.findings);
    return std::move(mesh.soup);
  }
};

}  // namespace

TetSoup make_soup(const Shape& shape, const std::filesystem::path& folder, std::vector<std::string>* findings,
                  const Monitor& monitor) {
  return std::visit(Maker{folder, findings, monitor}, shape);
}

}  // namespace griffith
