#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "sim/mesh/topology.h"
#include "sim/splinters/splinter_groups.h"
#include "sim/splinters/splinters.h"

namespace griffith {
namespace {

/// Affine map from rest space to a tet's barycentric weights.
class Barycentric {
 public:
  Barycentric(const TetMesh& mesh, TetId tet) {
    origin_ = mesh.rest_positions[mesh.tets[tet][0]];
    Mat3 edges;
    for (int i = 0; i < 3; ++i) edges.col(i) = mesh.rest_positions[mesh.tets[tet][i + 1]] - origin_;
    inverse_ = edges.inverse();
  }

  Weights weights(const Vec3& point) const {
    const Vec3 last = inverse_ * (point - origin_);
    return Eigen::Vector4d(1 - last.sum(), last[0], last[1], last[2]).cast<float>();
  }

 private:
  Vec3 origin_;
  Mat3 inverse_;
};

/// Builder of the splinters of one body.
class Builder {
 public:
  Builder(const TetMesh& mesh, const CellPartition& cells, const Monitor& monitor)
      : mesh_(mesh), cells_(cells), monitor_(monitor), fragments_(make_fragments(mesh, cells, monitor)) {
    contacts_ = find_contacts(mesh, cells, fragments_);
    require_not_cancelled();
    groups_ = group_fragments(cells, fragments_, contacts_);
    require_not_cancelled();
  }

  SplinterSet build() {
    make_parts();
    make_owners();
    make_links();
    require_not_cancelled();
    make_faces();
    return std::move(set_);
  }

 private:
  void require_not_cancelled() const {
    if (monitor_.is_cancelled()) throw Cancelled();
  }

  /// Makes the parts by splinter, then tet. `part_of_` maps fragments to them.
  void make_parts() {
    const int count = groups_.empty() ? 0 : 1 + *std::ranges::max_element(groups_);
    set_.splinters.resize(count);
    set_.parts_of_tet.resize(mesh_.tets.size());
    set_.parts_of_cell.resize(cells_.size());
    part_of_.resize(fragments_.size());
    order_.resize(fragments_.size());
    std::iota(order_.begin(), order_.end(), 0);
    std::ranges::stable_sort(order_, {}, [&](int i) { return groups_[i]; });
    for (const int i : order_) {
      const SplinterId splinter(groups_[i]);
      const TetId tet = fragments_[i].tet;
      if (set_.parts.empty() || set_.parts.back().splinter != splinter || set_.parts.back().tet != tet) {
        set_.parts_of_tet[tet].push_back(static_cast<int>(set_.parts.size()));
        if (set_.splinters[splinter].parts++ == 0)
          set_.splinters[splinter].first_part = static_cast<int>(set_.parts.size());
        set_.parts.push_back({splinter, tet});
      }
      set_.parts.back().volume += fragments_[i].volume;
      part_of_[i] = static_cast<int>(set_.parts.size()) - 1;
      set_.parts_of_cell[fragments_[i].cell].push_back(part_of_[i]);
    }
  }

  void make_owners() {
    for (Splinter& splinter : set_.splinters) {
      const std::span<const SplinterPart> parts(&set_.parts[splinter.first_part], splinter.parts);
      splinter.owner = std::ranges::max_element(parts, {}, &SplinterPart::volume)->tet;
      for (const SplinterPart& part : parts) splinter.volume += part.volume;
    }
  }

  void make_links() {
    for (const FragmentContact& contact : contacts_) {
      const int a = part_of_[contact.a], b = part_of_[contact.b];
      if (a < b && set_.parts[a].splinter == set_.parts[b].splinter && contact.tet_face >= 0)
        set_.links.push_back({a, b, contact.tet_face});
    }
    const auto key = [](const PartLink& link) { return std::pair(link.a, link.b); };
    std::ranges::sort(set_.links, {}, key);
    const auto rest = std::ranges::unique(set_.links, {}, key);
    set_.links.erase(rest.begin(), rest.end());
    set_.first_link.assign(set_.splinters.size() + 1, 0);
    for (const PartLink& link : set_.links) ++set_.first_link[set_.parts[link.a].splinter.index() + 1];
    std::partial_sum(set_.first_link.begin(), set_.first_link.end(), set_.first_link.begin());
  }

  void make_faces() {
    std::vector<int> first_contact(fragments_.size() + 1, 0);
    for (const FragmentContact& contact : contacts_) ++first_contact[contact.a + 1];
    std::partial_sum(first_contact.begin(), first_contact.end(), first_contact.begin());
    for (const int i : order_) {
      require_not_cancelled();
      const Fragment& fragment = fragments_[i];
      SplinterPart& part = set_.parts[part_of_[i]];
      if (part.faces == 0) part.first_face = static_cast<int>(set_.faces.size());
      for (const PolyhedronFace& face : fragment.polyhedron.faces)
        if (face.tet_face >= 0 && !mesh_.neighbors[fragment.tet][face.tet_face].valid())
          add_face(i, face, outline_of(fragment, face), -1);
      for (int c = first_contact[i]; c < first_contact[i + 1]; ++c) {
        const FragmentContact& contact = contacts_[c];
        if (!contact.is_wall || groups_[contact.a] == groups_[contact.b]) continue;
        const PolyhedronFace& face = fragment.polyhedron.faces[contact.face];
        add_face(i, face, contact.outline.empty() ? outline_of(fragment, face) : contact.outline, part_of_[contact.b]);
      }
      part.faces = static_cast<int>(set_.faces.size()) - part.first_face;
    }
  }

  static std::vector<Vec3> outline_of(const Fragment& fragment, const PolyhedronFace& face) {
    std::vector<Vec3> outline;
    for (const int corner : face.corners) outline.push_back(fragment.polyhedron.corners[corner]);
    return outline;
  }

  void add_face(int fragment, const PolyhedronFace& polygon, const std::vector<Vec3>& outline, int beyond) {
    const Fragment& source = fragments_[fragment];
    SplinterFace face;
    face.part = part_of_[fragment];
    face.beyond = beyond;
    face.tet_face = static_cast<std::int8_t>(polygon.tet_face);
    face.matter = cells_[source.cell].matter;
    face.first_corner = static_cast<int>(set_.corners.size());
    face.corners = static_cast<int>(outline.size());
    set_.faces.push_back(face);
    const Barycentric in_tet(mesh_, source.tet);
    const Barycentric in_owner(mesh_, set_.splinters[set_.parts[face.part].splinter].owner);
    for (const Vec3& place : outline)
      set_.corners.push_back({place.cast<float>(), in_tet.weights(place), in_owner.weights(place)});
  }

  const TetMesh& mesh_;
  const CellPartition& cells_;
  const Monitor& monitor_;
  std::vector<Fragment> fragments_;
  std::vector<FragmentContact> contacts_;
  std::vector<int> groups_, order_, part_of_;
  SplinterSet set_;
};

}  // namespace

SplinterSet make_splinters(const TetMesh& mesh, const CellPartition& cells, const Monitor& monitor) {
  return Builder(mesh, cells, monitor).build();
}

Uncovered uncovered_part(const TetMesh& mesh, const SplinterSet& splinters) {
  Uncovered uncovered;
  double maximum = 0;
  for (const TetId tet : IdRange<TetId>(0, mesh.tet_count())) {
    double missing = rest_volume(mesh, tet);
    for (const int part : splinters.parts_of_tet[tet]) missing -= splinters.parts[part].volume;
    uncovered.volume += missing;
    if (missing > maximum) maximum = missing, uncovered.place = rest_centroid(mesh, tet);
  }
  return uncovered;
}

void append(SplinterSet& all, const SplinterSet& of_body, TetId first_tet, int scene_body) {
  const SplinterId first_splinter(std::ssize(all.splinters));
  const int parts = static_cast<int>(all.parts.size());
  const int faces = static_cast<int>(all.faces.size()), corners = static_cast<int>(all.corners.size());
  const int links = static_cast<int>(all.links.size());
  for (Splinter splinter : of_body.splinters) {
    splinter.owner = splinter.owner.shifted(first_tet);
    splinter.scene_body = scene_body;
    splinter.first_part += parts;
    all.splinters.push_back(splinter);
  }
  for (SplinterPart part : of_body.parts) {
    part.splinter = part.splinter.shifted(first_splinter);
    part.tet = part.tet.shifted(first_tet);
    part.first_face += faces;
    all.parts.push_back(part);
  }
  for (const PartLink& link : of_body.links) all.links.push_back({link.a + parts, link.b + parts, link.face});
  if (!all.first_link.empty()) all.first_link.pop_back();
  for (const int first : of_body.first_link) all.first_link.push_back(first + links);
  for (SplinterFace face : of_body.faces) {
    face.part += parts;
    if (face.beyond >= 0) face.beyond += parts;
    face.first_corner += corners;
    all.faces.push_back(face);
  }
  all.corners.insert(all.corners.end(), of_body.corners.begin(), of_body.corners.end());
  all.parts_of_tet.resize(first_tet);
  for (std::vector<int> of_tet : of_body.parts_of_tet) {
    for (int& part : of_tet) part += parts;
    all.parts_of_tet.push_back(std::move(of_tet));
  }
}

}  // namespace griffith
