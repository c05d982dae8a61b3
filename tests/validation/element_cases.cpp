#include <Eigen/LU>
#include <Eigen/SVD>

#include "sim/elasticity/stiffness.h"
#include "tests/random_values.h"
#include "tests/validation/specimen.h"

namespace griffith::validation {
namespace {

using testing::RandomValues;

constexpr std::array<ElementModel, 2> kModels = {ElementModel::corotational, ElementModel::green_strain};

std::string name_of(ElementModel model) { return model == ElementModel::corotational ? "corotational" : "Green"; }

Scene block(BoxPattern pattern, int cells, ElementModel model) {
  Scene scene = validation_scene("block");
  BodyDescription& body = scene.bodies[0];
  auto& box = std::get<BoxShape>(body.shape);
  box.pattern = pattern;
  box.element_size = Vec3::Constant(box.size.z() / cells);
  body.material.element_model = model;
  return scene;
}

/// Hooke's law from E and ν alone.
Mat3 hooke(const Material& material, const Mat3& strain) {
  const double e = material.young_modulus, nu = material.poisson_ratio;
  return e / (1 + nu) * (strain + nu / (1 - 2 * nu) * strain.trace() * Mat3::Identity());
}

/// The Cauchy stress of a uniform deformation gradient, its rotation by singular values.
Mat3 uniform_stress(const Material& material, const Mat3& f) {
  if (material.element_model == ElementModel::green_strain) {
    const Mat3 strain = 0.5 * (f.transpose() * f - Mat3::Identity());
    return f * hooke(material, strain) * f.transpose() / f.determinant();
  }
  const Eigen::JacobiSVD<Mat3> svd(f, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3 q = svd.matrixU() * svd.matrixV().transpose();
  const Mat3 stretch = q.transpose() * f;
  return q * hooke(material, 0.5 * (stretch + stretch.transpose()) - Mat3::Identity()) * q.transpose();
}

double largest(const std::vector<Vec3>& vectors, const std::vector<int>& nodes) {
  double size = 0;
  for (int node : nodes) size = std::max(size, vectors[node].norm());
  return size;
}

std::vector<int> interior_nodes(const Specimen& specimen, const Vec3& size) {
  return specimen.nodes_where([&](const Vec3& x) { return ((size / 2 - x.cwiseAbs()).array() > 1e-9).all(); });
}

/// Tet of about a meter, and the same one strained by some percent.
struct Element {
  RestElement rest;
  Corners corners;
};

Element random_element(RandomValues& random, double strain) {
  for (;;) {
    Corners corners;
    for (int i = 0; i < 4; ++i) corners.col(i) = random.vector();
    const Mat3 edges = corners.rightCols<3>().colwise() - corners.col(0);
    if (edges.determinant() < 0.1) continue;
    const Element element{rest_element(corners), corners};
    return {element.rest, (Mat3::Identity() + random.matrix(strain)) * corners};
  }
}

ElementState state_of(const ElasticLaw& law, const RestElement& rest, const Corners& corners) {
  return element_state(law, element_deformation(law.model, rest, corners));
}

Corners forces_of(const ElasticLaw& law, const RestElement& rest, const Corners& corners) {
  const ElementState state = state_of(law, rest, corners);
  return nodal_forces(rest, state.frame, state.stress);
}

double energy_of(const ElasticLaw& law, const RestElement& rest, const Corners& corners) {
  return rest.volume * state_of(law, rest, corners).energy_density;
}

/// The slope of a function of the corners along their component i, by differences of fourth order.
template <class Function>
auto slope(const Function& function, const Corners& corners, int i) {
  constexpr double kStep = 2e-4;  // [m]
  const auto at = [&](double steps) {
    Corners moved = corners;
    moved(i) += steps * kStep;
    return function(moved);
  };
  using Value = decltype(function(corners));
  return Value((8 * (at(1) - at(-1)) - (at(2) - at(-2))) / (12 * kStep));
}

/// |f + ∂E/∂x| / |f|.
double force_error(const ElasticLaw& law, const Element& element) {
  const Corners forces = forces_of(law, element.rest, element.corners);
  const auto energy = [&](const Corners& corners) { return energy_of(law, element.rest, corners); };
  Corners gradient;
  for (int i = 0; i < 12; ++i) gradient(i) = slope(energy, element.corners, i);
  return (forces + gradient).norm() / forces.norm();
}

/// |K + ∂f/∂x| / |K|.
double stiffness_error(const ElasticLaw& law, const Element& element) {
  const ElementState state = state_of(law, element.rest, element.corners);
  const auto forces = [&](const Corners& corners) { return forces_of(law, element.rest, corners); };
  double error = 0, size = 0;
  for (int i = 0; i < 12; ++i) {
    const Corners force_slope = slope(forces, element.corners, i);
    for (int corner = 0; corner < 4; ++corner) {
      const Vec3 column = stiffness_row(law, element.rest, state, corner).block(i / 3).col(i % 3);
      error += (column + force_slope.col(corner)).squaredNorm();
      size += column.squaredNorm();
    }
  }
  return std::sqrt(error / size);
}

/// |f(R x) − R f(x)| / |f|.
double rotation_error(const ElasticLaw& law, const Element& element, const Mat3& rotation) {
  const Corners forces = forces_of(law, element.rest, element.corners);
  return (forces_of(law, element.rest, rotation * element.corners) - rotation * forces).norm() / forces.norm();
}

/// An element in tension along every axis: here alone the matrix of Green's strain has its whole geometric part.
Element stretched(Element element) {
  Mat3 stretch = Vec3(1.3, 1.2, 1.1).asDiagonal();
  element.corners = stretch * element.corners;
  return element;
}

}  // namespace

std::vector<Row> affine_deformation(Extent) {
  const Mat3 gradient = testing::RandomValues(1).rotation() *
                        (Mat3() << 1.002, 0.001, 0, -0.0005, 0.999, 0.0015, 0.001, 0, 1.001).finished();
  std::vector<Row> rows;
  for (ElementModel model : kModels)
    for (BoxPattern pattern : kPatterns)
      for (int cells : {2, 4}) {
        const Scene scene = block(pattern, cells, model);
        Specimen specimen(scene);
        specimen.deform([&](const Vec3& x) -> Vec3 { return gradient * x + Vec3(1, 2, 3); });
        const Mat3 expected = uniform_stress(scene.bodies[0].material, gradient);
        double error = 0;
        for (const Mat3& stress : specimen.stresses()) error = std::max(error, (stress - expected).norm());
        const auto& box = std::get<BoxShape>(scene.bodies[0].shape);
        const double force = expected.norm() * box.element_size.squaredNorm() / 3;
        const MeshLabel mesh = mesh_label(pattern, cells);
        const std::string name = name_of(model);
        rows.push_back(at_most(mesh, name + ": stress, largest error", 1e-6, error / expected.norm()));
        rows.push_back(at_most(mesh, name + ": force inside / (stress × h²)", 1e-9,
                               largest(specimen.elastic_forces(), interior_nodes(specimen, box.size)) / force));
      }
  return rows;
}

std::vector<Row> rigid_motion(Extent) {
  std::vector<Row> rows;
  RandomValues random(2);
  for (ElementModel model : kModels)
    for (BoxPattern pattern : kPatterns) {
      const Scene scene = block(pattern, 4, model);
      const double young_modulus = scene.bodies[0].material.young_modulus;
      const double area = std::get<BoxShape>(scene.bodies[0].shape).element_size.squaredNorm() / 3;
      Specimen specimen(scene);
      double strain = 0, force = 0;
      for (int i = 0; i < 20; ++i) {
        const Mat3 rotation = random.rotation();
        specimen.deform([&](const Vec3& x) -> Vec3 { return rotation * x + Vec3(1, -2, 3); });
        for (const Mat3& stress : specimen.stresses()) strain = std::max(strain, stress.norm() / young_modulus);
        for (const Vec3& f : specimen.elastic_forces()) force = std::max(force, f.norm() / (young_modulus * area));
      }
      const MeshLabel mesh = mesh_label(pattern, 4);
      rows.push_back(at_most(mesh, name_of(model) + ": stress / E", 1e-13, strain));
      rows.push_back(at_most(mesh, name_of(model) + ": nodal force / (E h²)", 1e-13, force));
    }
  return rows;
}

std::vector<Row> difference_quotients(Extent) {
  const MeshLabel mesh{"-", "50 random tets"};
  std::vector<Row> rows;
  for (ElementModel model : kModels) {
    Material material;
    material.element_model = model;
    material.young_modulus = 1e6;
    material.poisson_ratio = 0.3;
    const ElasticLaw law = elastic_law(material);
    RandomValues random(3);
    double force = 0, stiffness = 0, rotated = 0;
    for (int i = 0; i < 50; ++i) {
      const Element strained = random_element(random, 0.2), resting = random_element(random, 0);
      force = std::max(force, force_error(law, strained));
      rotated = std::max(rotated, rotation_error(law, strained, random.rotation()));
      const bool green = model == ElementModel::green_strain;
      stiffness = std::max(stiffness, stiffness_error(law, green ? stretched(resting) : resting));
    }
    const bool green = model == ElementModel::green_strain;
    rows.push_back(at_most(mesh, name_of(model) + ": force and energy's slope", 1e-8, force));
    rows.push_back(at_most(mesh,
                           name_of(model) + ": stiffness and force's slope, " + (green ? "in tension" : "at rest"),
                           1e-8, stiffness));
    rows.push_back(at_most(mesh, name_of(model) + ": f(Rx) and R f(x)", 1e-12, rotated));
  }
  return rows;
}

}  // namespace griffith::validation
