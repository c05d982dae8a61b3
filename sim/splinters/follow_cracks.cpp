#include <algorithm>

#include "sim/core/sort_unique.h"
#include "sim/splinters/carried_corner.h"

namespace griffith {
namespace {

using Neighbors = std::span<const std::array<TetId, 4>>;

/// Finds the parts that are still connected with the owner.
void update_attachment(const SplinterSet& set, Neighbors neighbors, SplinterId id, SplinterState& state) {
  const Splinter& splinter = set.splinters[id];
  const auto attached = state.attached.begin() + splinter.first_part;
  for (int i = 0; i < splinter.parts; ++i) attached[i] = set.parts[splinter.first_part + i].tet == splinter.owner;
  const std::span<const PartLink> links(set.links.data() + set.first_link[id],
                                        set.links.data() + set.first_link[id.index() + 1]);
  for (bool grew = true; grew;) {
    grew = false;
    for (const PartLink& link : links) {
      if (state.attached[link.a] == state.attached[link.b]) continue;
      if (!neighbors[set.parts[link.a].tet][link.face].valid()) continue;
      state.attached[link.a] = state.attached[link.b] = 1;
      grew = true;
    }
  }
}

/// True if the tets of the two sides of a wall have separated.
bool has_opened(const SplinterSet& set, Neighbors neighbors, const SplinterState& state, const SplinterFace& face) {
  const auto carrier_of = [&](int part) { return carrier(set.splinters, set.parts, state.attached, part); };
  if (carrier_of(face.part) == carrier_of(face.beyond)) return false;
  if (!state.attached[face.part] || !state.attached[face.beyond]) return true;
  // A wall in the face between two tets follows both.
  return !neighbors[set.parts[face.part].tet][face.tet_face].valid();
}

void open(SplinterState& state, int face) {
  if (state.open[face]) return;
  state.open[face] = 1;
  state.open_walls.push_back(face);
}

/// Opens the walls of a splinter that have to open, on both sides.
void open_walls(const SplinterSet& set, Neighbors neighbors, SplinterId id, SplinterState& state) {
  const Splinter& splinter = set.splinters[id];
  for (int p = splinter.first_part; p < splinter.first_part + splinter.parts; ++p) {
    const SplinterPart& part = set.parts[p];
    for (int f = part.first_face; f < part.first_face + part.faces; ++f) {
      if (state.open[f] || !has_opened(set, neighbors, state, set.faces[f])) continue;
      open(state, f);
      const SplinterPart& beyond = set.parts[set.faces[f].beyond];
      for (int g = beyond.first_face; g < beyond.first_face + beyond.faces; ++g)
        if (set.faces[g].beyond == p) open(state, g);
    }
  }
}

}  // namespace

SplinterState intact_state(const SplinterSet& splinters) {
  SplinterState state;
  state.attached.assign(splinters.parts.size(), 1);
  for (const SplinterFace& face : splinters.faces) state.open.push_back(face.beyond < 0);
  return state;
}

void follow_cracks(const SplinterSet& splinters, Neighbors neighbors, std::span<const TetId> changed_tets,
                   SplinterState& state) {
  std::vector<SplinterId> touched;
  for (const TetId tet : changed_tets) {
    if (static_cast<std::size_t>(tet) >= splinters.parts_of_tet.size()) continue;  // tet of a body without splinters
    for (const int part : splinters.parts_of_tet[tet]) touched.push_back(splinters.parts[part].splinter);
  }
  sort_unique(touched);
  for (const SplinterId id : touched) update_attachment(splinters, neighbors, id, state);
  for (const SplinterId id : touched) open_walls(splinters, neighbors, id, state);
}

}  // namespace griffith
