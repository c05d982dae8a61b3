#include "sim/splinters/splinter_groups.h"

#include <algorithm>
#include <numeric>

#include "sim/geometry/disjoint_sets.h"

namespace griffith {
namespace {

/// Largest volume of a splinter that joins its neighbor, relative to the neighbor's.
constexpr double kSmallestFraction = 0.1;

/// Index of fragments by tet and cell.
class FragmentTable {
 public:
  FragmentTable(const std::vector<Fragment>& fragments, int tets) : fragments_(fragments), first_(tets + 1, 0) {
    for (const Fragment& fragment : fragments) ++first_[fragment.tet.index() + 1];
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
  }

  /// Returns -1 if there is none.
  int find(TetId tet, int cell) const {
    const auto begin = fragments_.begin() + first_[tet], end = fragments_.begin() + first_[tet.index() + 1];
    const auto found = std::ranges::lower_bound(begin, end, cell, {}, &Fragment::cell);
    return found != end && found->cell == cell ? static_cast<int>(found - fragments_.begin()) : -1;
  }

 private:
  const std::vector<Fragment>& fragments_;
  std::vector<int> first_;
};

/// Returns the neighbor with the largest common wall, per group that is small beside it; -1 for the others.
std::vector<int> neighbors_to_join(const std::vector<FragmentContact>& contacts, const std::vector<double>& volumes,
                                   DisjointSets& groups) {
  struct Common {
    int group, neighbor;
    double area;
  };
  std::vector<Common> walls;
  for (const FragmentContact& contact : contacts) {
    const int group = groups.find(contact.a), neighbor = groups.find(contact.b);
    if (group != neighbor && contact.is_wall) walls.push_back({group, neighbor, contact.area});
  }
  std::ranges::stable_sort(walls, {}, [](const Common& wall) { return std::pair(wall.group, wall.neighbor); });
  std::vector<int> chosen(volumes.size(), -1);
  std::vector<double> largest(volumes.size(), 0);
  for (std::size_t i = 0; i < walls.size();) {
    const auto [group, neighbor, ignored] = walls[i];
    double area = 0;
    for (; i < walls.size() && walls[i].group == group && walls[i].neighbor == neighbor; ++i) area += walls[i].area;
    if (area <= largest[group]) continue;
    largest[group] = area;
    chosen[group] = neighbor;
  }
  for (std::size_t group = 0; group < chosen.size(); ++group)
    if (chosen[group] >= 0 && volumes[group] >= kSmallestFraction * volumes[chosen[group]]) chosen[group] = -1;
  return chosen;
}

std::vector<double> group_volumes(const std::vector<Fragment>& fragments, DisjointSets& groups) {
  std::vector<double> volumes(fragments.size(), 0);
  for (std::size_t i = 0; i < fragments.size(); ++i) volumes[groups.find(static_cast<int>(i))] += fragments[i].volume;
  return volumes;
}

/// Joins all small groups in each round. The joined ones may be small beside others.
void join_small_groups(const std::vector<Fragment>& fragments, const std::vector<FragmentContact>& contacts,
                       DisjointSets& groups) {
  for (bool joined = true; joined;) {
    joined = false;
    const std::vector<int> chosen = neighbors_to_join(contacts, group_volumes(fragments, groups), groups);
    for (std::size_t group = 0; group < chosen.size(); ++group) {
      if (chosen[group] < 0) continue;
      groups.join(static_cast<int>(group), chosen[group]);
      joined = true;
    }
  }
}

/// Returns the cells behind a face: beyond its wall, of which a side may have several, or the same cell.
std::vector<int> cells_beyond(const ConvexCell& cell, int own, int wall) {
  if (wall < 0) return {own};
  std::vector<int> beyond;
  const HalfSpace& side = cell.walls[wall].inside;
  for (std::size_t i = wall; i < cell.walls.size(); ++i) {
    const HalfSpace& inside = cell.walls[i].inside;
    if (inside.normal != side.normal || inside.offset != side.offset) break;
    if (cell.walls[i].neighbor >= 0) beyond.push_back(cell.walls[i].neighbor);
  }
  return beyond;
}

/// Returns the part of a face of a cell's fragment that a neighbor covers.
std::vector<Vec3> shared_outline(const ConvexPolyhedron& polyhedron, const PolyhedronFace& face,
                                 const ConvexCell& neighbor, int cell) {
  std::vector<Vec3> outline;
  for (const int corner : face.corners) outline.push_back(polyhedron.corners[corner]);
  const auto towards = std::ranges::find(neighbor.walls, cell, &CellWall::neighbor);
  for (const CellWall& wall : neighbor.walls)
    if (wall.inside.normal != towards->inside.normal || wall.inside.offset != towards->inside.offset)
      outline = clipped(outline, wall.inside);
  return outline;
}

/// Adds the contacts of a face with the fragments in the tet beyond it. `contact` has the face.
void add_contacts(const CellPartition& cells, const std::vector<Fragment>& fragments, const FragmentTable& table,
                  TetId beyond, FragmentContact contact, std::vector<FragmentContact>& contacts) {
  const Fragment& fragment = fragments[contact.a];
  const PolyhedronFace& face = fragment.polyhedron.faces[contact.face];
  const std::vector<int> neighbors = cells_beyond(cells[fragment.cell], fragment.cell, face.wall);
  for (const int cell : neighbors) {
    contact.b = table.find(beyond, cell);
    if (contact.b < 0) continue;  // thinner than rounding
    if (neighbors.size() == 1) {
      contact.area = area_vector(fragment.polyhedron, face).norm();
    } else {
      contact.outline = shared_outline(fragment.polyhedron, face, cells[cell], fragment.cell);
      contact.area = area_vector(contact.outline).norm();
      if (contact.area == 0) continue;
    }
    contacts.push_back(contact);
  }
}

}  // namespace

std::vector<FragmentContact> find_contacts(const TetMesh& mesh, const CellPartition& cells,
                                           const std::vector<Fragment>& fragments) {
  const FragmentTable table(fragments, mesh.tet_count());
  std::vector<FragmentContact> contacts;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    const std::vector<PolyhedronFace>& faces = fragments[i].polyhedron.faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const int tet_face = faces[f].tet_face;
      const TetId beyond = tet_face < 0 ? fragments[i].tet : mesh.neighbors[fragments[i].tet][tet_face];
      if (!beyond.valid()) continue;
      add_contacts(cells, fragments, table, beyond,
                   {static_cast<int>(i), -1, tet_face, faces[f].wall >= 0, static_cast<int>(f)}, contacts);
    }
  }
  return contacts;
}

std::vector<int> group_fragments(const CellPartition& cells, const std::vector<Fragment>& fragments,
                                 const std::vector<FragmentContact>& contacts) {
  DisjointSets groups(static_cast<int>(fragments.size()));
  for (const FragmentContact& contact : contacts)
    if (cells[fragments[contact.a].cell].splinter == cells[fragments[contact.b].cell].splinter)
      groups.join(contact.a, contact.b);
  join_small_groups(fragments, contacts, groups);
  std::vector<int> numbers(fragments.size(), -1), splinters;
  int count = 0;
  for (std::size_t i = 0; i < fragments.size(); ++i) {
    int& number = numbers[groups.find(static_cast<int>(i))];
    if (number < 0) number = count++;
    splinters.push_back(number);
  }
  return splinters;
}

}  // namespace griffith
