#include "sim/world/setup/residual_strains.h"

#include <algorithm>
#include <limits>
#include <string>

#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/mesh/file_cursor.h"
#include "sim/scene/body_pose.h"
#include "sim/world/state/corners.h"

namespace griffith {
namespace {

/// Returns the tets of a scene body, ascending.
std::vector<TetId> tets_of(const WorldState& world, int scene_body) {
  std::vector<TetId> tets;
  for (const Body& body : world.bodies)
    if (body.scene_body == scene_body) tets.insert(tets.end(), body.tets.begin(), body.tets.end());
  std::ranges::sort(tets);
  return tets;
}

Mat3 symmetric(const Vec3& strain, const Vec3& shear) {
  Mat3 tensor = strain.asDiagonal();
  tensor(1, 2) = tensor(2, 1) = shear.x();
  tensor(0, 2) = tensor(2, 0) = shear.y();
  tensor(0, 1) = tensor(1, 0) = shear.z();
  return tensor;
}

/// Reads a row for each of `count` tets.
std::vector<Mat3> read_strains(const std::filesystem::path& path, std::size_t count) {
  FileCursor cursor(path, ",;", '#');
  std::vector<Mat3> strains;
  while (!cursor.at_end()) {
    Vec3 strain, shear;
    for (double& component : strain) component = cursor.number<double>("a strain");
    for (double& component : shear) component = cursor.number<double>("a shear strain");
    strains.push_back(symmetric(strain, shear));
  }
  if (strains.size() != count)
    throw InputError(path.string(), "holds the strains of " + std::to_string(strains.size()) + " tetrahedra",
                     "the body's mesh has " + std::to_string(count) + "; write xx, yy, zz, yz, xz, xy for each");
  return strains;
}

/// Returns the strain of each tet that causes a parabolic stress: its mean over the tet.
std::vector<Mat3> parabolic_strains(const WorldState& world, const std::vector<TetId>& tets, const Vec3& normal,
                                    double surface_stress, const Material& material) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const TetId tet : tets)
    for (const NodeId node : world.mesh->tets[tet]) {
      const double height = world.mesh->rest_positions[node].dot(normal);
      low = std::min(low, height), high = std::max(high, height);
    }
  const Mat3 plane = Mat3::Identity() - normal * normal.transpose();
  const double compliance = (1 - material.poisson_ratio) / material.young_modulus;
  std::vector<Mat3> strains;
  for (const TetId tet : tets) {
    double sum = 0, squares = 0;
    for (const NodeId node : world.mesh->tets[tet]) {
      const double zeta = (world.mesh->rest_positions[node].dot(normal) - (low + high) / 2) / (high - low);
      sum += zeta, squares += zeta * zeta;
    }
    const double mean_square = (squares + sum * sum) / 20;
    strains.push_back(-compliance * surface_stress * (12 * mean_square - 1) / 2 * plane);
  }
  return strains;
}

}  // namespace

void set_residual_strains(const WorldState& world, int scene_body, ElementArrays& elements) {
  const BodyDescription& description = world.model->scene.bodies[scene_body];
  if (!description.residual_stress) return;
  const std::vector<TetId> tets = tets_of(world, scene_body);
  const Mat3 rotation = pose_of(description).rotation.toRotationMatrix();
  std::vector<Mat3> strains;
  if (const auto* parabolic = std::get_if<ParabolicStress>(&*description.residual_stress))
    strains = parabolic_strains(world, tets, rotation * parabolic->normal.normalized(), parabolic->surface_stress,
                                world.materials[scene_body]);
  else if (const auto* uniform = std::get_if<UniformStrain>(&*description.residual_stress))
    strains.assign(tets.size(), rotation * symmetric(uniform->strain, uniform->shear) * rotation.transpose());
  else {
    strains = read_strains(
        file_path(world.model->scene.folder, std::get<StrainFile>(*description.residual_stress).path), tets.size());
    for (Mat3& strain : strains) strain = rotation * strain * rotation.transpose();
  }
  elements.allow_strains();
  for (std::size_t i = 0; i < tets.size(); ++i) elements.plastic_strains[tets[i]] = strains[i];
}

void check_residual_stress(const Scene& scene, int scene_body, const Material& material) {
  if (scene.bodies[scene_body].residual_stress && material.yield_strength)
    throw InputError("#/bodies/" + std::to_string(scene_body) + "/residual_stress", "is set for a material that yields",
                     "remove it or the material's yield_strength");
}

void reset_residual_strains(const WorldState& world, int scene_body, ElementArrays& elements) {
  const std::optional<ResidualStress>& residual = world.model->scene.bodies[scene_body].residual_stress;
  if (!elements.point_strains.empty())
    for (const TetId tet : tets_of(world, scene_body)) elements.point_strains[tet] = at_all_corners(Mat3::Zero());
  if (elements.plastic_strains.empty() || (residual && std::holds_alternative<StrainFile>(*residual))) return;
  for (const TetId tet : tets_of(world, scene_body)) elements.plastic_strains[tet].setZero();
  set_residual_strains(world, scene_body, elements);
}

}  // namespace griffith
