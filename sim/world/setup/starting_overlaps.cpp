#include "sim/world/setup/starting_overlaps.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <map>
#include <utility>

#include "sim/contact/contact_world.h"

namespace griffith {
namespace {

/// Overlap up to which bodies count as touching, since collision shapes are approximate [of the smaller body's size].
constexpr double kTolerance = 0.005;

constexpr int kGround = -1;

/// Depths of overlap of pairs of scene bodies, the first of which may be the ground [m].
using Depths = std::map<std::pair<int, int>, double>;

using Boxes = std::vector<Eigen::AlignedBox3d>;

/// Returns the boxes of the scene bodies.
Boxes boxes_of(const Scene& scene, const Frame& frame) {
  Boxes boxes(scene.bodies.size());
  for (std::size_t tet = 0; tet < frame.elements.tets.size(); ++tet)
    for (const NodeId corner : frame.elements.tets[tet])
      boxes[frame.bodies[frame.elements.bodies[tet]].scene_body].extend(frame.nodes.rest_positions[corner]);
  return boxes;
}

void add_ground(const Scene& scene, const Boxes& boxes, Depths& depths) {
  if (!scene.ground) return;
  for (std::size_t i = 0; i < boxes.size(); ++i)
    depths[{kGround, static_cast<int>(i)}] = scene.ground->height - boxes[i].min().y();
}

/// Adds overlapping pairs. All bodies are free here: two held ones have no contacts but may overlap.
void add_pairs(const Frame& frame, const Boxes& boxes, Depths& depths) {
  ContactWorld contacts(Vec3::Zero());
  std::vector<ContactWorld::Proxy> proxies;
  for (const BodyView& body : frame.bodies) {
    RigidState state;
    state.pose = {body.center_of_mass, body.orientation};
    proxies.push_back({body.collision_parts, {body.mass, Mat3::Identity()}, Mobility::free, state, {}});
  }
  const std::vector<ProxyId> ids = contacts.add_proxies(proxies);
  contacts.detect();
  for (std::size_t i = 0; i < ids.size(); ++i)
    for (std::size_t j = i + 1; j < ids.size(); ++j) {
      const auto [first, second] = std::minmax({frame.bodies[i].scene_body, frame.bodies[j].scene_body});
      if (first == second || !boxes[first].intersects(boxes[second])) continue;
      // What overlaps when first seen remains allowed, also where contacts on opposite sides are dropped.
      double& depth = depths[{first, second}];
      depth = std::max(depth, contacts.allowed_overlap(ids[i], ids[j]));
    }
}

InputError finding(const Scene& scene, const std::pair<int, int>& pair, double depth) {
  const auto name = [&](int body) { return "\"" + scene.bodies[body].name + "\""; };
  char text[32];
  std::snprintf(text, sizeof text, " starts %.3g m ", depth);
  return {"#/bodies/" + std::to_string(pair.second) + "/position",
          name(pair.second) + text + (pair.first == kGround ? "under the ground" : "inside " + name(pair.first)),
          pair.first == kGround ? "raise it" : "move them apart"};
}

}  // namespace

std::vector<InputError> starting_overlaps(const Scene& scene, const Frame& start) {
  const Boxes boxes = boxes_of(scene, start);
  Depths depths;
  add_ground(scene, boxes, depths);
  add_pairs(start, boxes, depths);
  std::erase_if(depths, [&](const auto& entry) {
    const auto& [first, second] = entry.first;
    const double size = boxes[second].diagonal().norm();
    return entry.second <= kTolerance * (first == kGround ? size : std::min(size, boxes[first].diagonal().norm()));
  });
  std::vector<std::pair<std::pair<int, int>, double>> deepest(depths.begin(), depths.end());
  std::ranges::stable_sort(deepest, std::greater(), &std::pair<std::pair<int, int>, double>::second);
  std::vector<InputError> findings;
  for (const auto& [pair, depth] : deepest) findings.push_back(finding(scene, pair, depth));
  return findings;
}

}  // namespace griffith
