#include "sim/world/contact/pressure_distribution.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "sim/mesh/topology.h"

namespace griffith {
namespace {

constexpr double kFacing = 0.95;  // cosine between normals of one face
constexpr double kPoint = 1e-4;   // of the extent of a patch: pressures closer together act on one point

/// Returns the area that belongs to the node of a contact, of the faces that look along the normal there [m²].
double area_at(const WorldState& world, const Contact& contact) {
  const NodeId node = contact.node_a.valid() ? contact.node_a : contact.node_b;
  const double side = contact.node_a.valid() ? -1 : 1;
  double area = 0;
  for (const TetId tet : world.mesh->stars[node])
    for (int face = 0; face < 4; ++face) {
      const std::array<NodeId, 3> corners = face_nodes(world.mesh, tet, face);
      if (world.mesh->neighbors[tet][face].valid() || std::ranges::find(corners, node) == corners.end()) continue;
      const Vec3 normal = area_vector(world.nodes.positions, corners);
      if (side * normal.dot(contact.normal) > kFacing * normal.norm()) area += normal.norm() / 3;
    }
  return area;
}

/// Sum of impulses on the first object of a patch: along the normal and the surface, with their moments about the
/// origin of a plane frame.
struct Resultant {
  Vec3 normal = Vec3::Zero();  ///< sum of the normal impulses [N·s] and their moments of the two coordinates [N·s·m]
  Vec3 sliding = Vec3::Zero();  ///< along the surface, world frame [N·s]
  double torque = 0;            ///< moment of the latter about the normal [N·m·s]
};

/// Frame of a patch: coordinates along the surface about its first node.
class PatchFrame {
 public:
  explicit PatchFrame(const FacePatch& patch)
      : origin_(patch.nodes.front().position),
        normal_(patch.nodes.front().normal),
        first_(normal_.unitOrthogonal()),
        second_(normal_.cross(first_)) {}

  const Vec3& normal() const { return normal_; }
  /// Returns 1 and the two coordinates of a place [-, m].
  Vec3 moments(const Vec3& place) const { return {1, first_.dot(place - origin_), second_.dot(place - origin_)}; }
  Vec3 along_surface(const Vec3& moments) const { return moments[1] * first_ + moments[2] * second_; }

  Resultant resultant(const WorldState& world, const FacePatch& patch) const {
    Resultant sum;
    for (const int index : patch.contacts) {
      const Contact& contact = world.contact_world.contacts()[index];
      const Vec3 impulse = contact.a == patch.nodes.front().a ? contact.impulse : Vec3(-contact.impulse);
      const double pushing = normal_.dot(impulse);
      const Vec3 at = moments(contact.position), sliding = impulse - pushing * normal_;
      sum.normal += pushing * at;
      sum.sliding += sliding;
      sum.torque += normal_.dot(along_surface(at).cross(sliding));
    }
    return sum;
  }

 private:
  Vec3 origin_, normal_, first_, second_;
};

/// Distributes the impulses of a patch over its nodes: along the normal by even_pressures(), along the surface in
/// proportion to these. False if no pressures do.
bool distribute(const WorldState& world, FacePatch& patch) {
  if (patch.nodes.size() < 3) return false;
  const PatchFrame frame(patch);
  const Resultant sum = frame.resultant(world, patch);
  const auto count = static_cast<Eigen::Index>(patch.nodes.size());
  Eigen::Matrix3Xd moments(3, count);
  Eigen::VectorXd areas(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    moments.col(i) = frame.moments(patch.nodes[i].position);
    areas[i] = area_at(world, patch.nodes[i]);
  }
  if (!(sum.normal[0] > 0)) return false;
  const std::optional<Eigen::VectorXd> pressures = even_pressures(moments, areas, sum.normal);
  if (!pressures) return false;
  const Vec3 center = frame.along_surface(sum.normal) / sum.normal[0];
  double arms = 0;
  for (Eigen::Index i = 0; i < count; ++i)
    arms += (*pressures)[i] * (frame.along_surface(moments.col(i)) - center).squaredNorm();
  const double torque = sum.torque - frame.normal().dot(center.cross(sum.sliding));
  const double extent = moments.bottomRows<2>().colwise().norm().maxCoeff();
  const bool is_point = arms <= kPoint * kPoint * extent * extent * sum.normal[0];  // has no torque but rounding errors
  const double turn = is_point ? 0 : torque / arms;
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vec3 arm = frame.along_surface(moments.col(i)) - center;
    patch.nodes[i].impulse =
        (*pressures)[i] * (frame.normal() + sum.sliding / sum.normal[0] + turn * frame.normal().cross(arm));
  }
  return true;
}

}  // namespace

std::optional<Eigen::VectorXd> even_pressures(const Eigen::Matrix3Xd& moments, const Eigen::VectorXd& areas,
                                              const Vec3& resultant) {
  constexpr double kRounding = 1e-9;
  const double extent = moments.bottomRows<2>().cwiseAbs().maxCoeff();
  if (!(extent > 0)) return {};
  const Vec3 unit(1, 1 / extent, 1 / extent);
  const Eigen::Matrix3Xd scaled = unit.asDiagonal() * moments;
  const Vec3 wanted = unit.cwiseProduct(resultant);
  Eigen::VectorXd open = areas;  // 0 where nothing presses
  for (Eigen::Index left = areas.size(); left > 0; --left) {
    const Eigen::SelfAdjointEigenSolver<Mat3> modes(scaled * open.asDiagonal() * scaled.transpose());
    Vec3 inverse = Vec3::Zero();
    for (int i = 0; i < 3; ++i)
      if (modes.eigenvalues()[i] > kRounding * modes.eigenvalues()[2]) inverse[i] = 1 / modes.eigenvalues()[i];
    const Vec3 linear = modes.eigenvectors() * inverse.asDiagonal() * modes.eigenvectors().transpose() * wanted;
    const Eigen::VectorXd pressures = open.cwiseProduct(scaled.transpose() * linear);
    if (!((scaled * pressures - wanted).cwiseAbs().maxCoeff() <= 1e3 * kRounding * wanted[0])) return {};
    Eigen::Index lowest = 0;
    if (pressures.minCoeff(&lowest) >= 0) return pressures;
    open[lowest] = 0;
  }
  return {};
}

SpreadContacts spread_impulses(const WorldState& world) {
  SpreadContacts spread{std::vector<bool>(world.contact_world.contacts().size(), false), {}};
  for (FacePatch& patch : rigid_patches(world)) {
    if (!distribute(world, patch)) continue;
    for (const int contact : patch.contacts) spread.replaced[contact] = true;
    spread.added.insert(spread.added.end(), patch.nodes.begin(), patch.nodes.end());
  }
  return spread;
}

}  // namespace griffith
