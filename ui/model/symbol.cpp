#include "ui/model/symbol.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "sim/elasticity/principal_stress.h"
#include "sim/fracture/fracture_law.h"
#include "ui/model/units.h"
#include "ui/model/verdict.h"

namespace griffith::ui {
namespace {

std::string piece_text(const Frame& frame, const Scene& scene, BodyId id) {
  const auto body = static_cast<std::size_t>(frame.bodies[id].scene_body);
  const std::string name = body < scene.bodies.size() ? scene.bodies[body].name : "body";
  return name + ", piece " + std::to_string(id.index());
}

SymbolReport plane_report(const CrackEvent& crack, const Frame& frame, const Scene& scene) {
  const Material& material = frame.materials[static_cast<std::size_t>(frame.bodies[crack.body].scene_body)];
  const std::string unit(fracture_law(material).unit);
  const std::string load = format_quantity(crack.load, unit), resistance = format_quantity(crack.resistance, unit);
  SymbolReport report{"Crack plane", {}, {}};
  report.sentence = "Node " + std::to_string(crack.node.index()) +
                    (crack.torn_off ? " tore off its support" : " cracked") + " across this plane: the load " + load +
                    " exceeded the resistance " + resistance + ".";
  report.rows = {{"Node", std::to_string(crack.node.index())},
                 {"Of", piece_text(frame, scene, crack.body)},
                 {"Time", format_quantity(crack.time, "s") + ", in step " + std::to_string(step_of(crack))},
                 {"Plane normal", direction_text(crack.normal)},
                 {"Load", load},
                 {"Resistance", resistance},
                 {"Utilization", format_quantity(crack.load / crack.resistance, "", 3)},
                 {"Largest eigenvalue", format_quantity(crack.eigenvalue, "N", 3)},
                 {"Elements there", std::to_string(crack.elements.size())},
                 {"Nodes created", std::to_string(crack.nodes_made)}};
  if (!crack.children.empty()) report.rows.push_back({"Pieces at it after", std::to_string(crack.children.size())});
  if (crack.scaled) report.rows.push_back({"Scaled", scale_text(*crack.scaled)});
  return report;
}

/// Returns the projectile that touches a place; null: none.
const ProjectileView* projectile_at(const Frame& frame, const Vec3& place) {
  constexpr double kSlack = 1.2;  // it has moved on since
  for (const ProjectileView& projectile : frame.projectiles)
    if ((projectile.position - place).norm() < kSlack * projectile.radius) return &projectile;
  return nullptr;
}

/// Side of a contact: its name, and its velocity at the place after the step [m/s].
struct Side {
  std::string name;
  Vec3 velocity = Vec3::Zero();
};

Side side_of(BodyId id, const Vec3& place, const Frame& frame, const Scene& scene) {
  if (id.valid()) {
    const BodyView& body = frame.bodies[id];
    return {piece_text(frame, scene, id), body.velocity + body.angular_velocity.cross(place - body.center_of_mass)};
  }
  if (const ProjectileView* projectile = projectile_at(frame, place)) return {"a projectile", projectile->velocity};
  return {"the ground", Vec3::Zero()};
}

SymbolReport contact_report(ContactView contact, const Frame& frame, const Scene& scene, double duration) {
  constexpr double kNoise = 1e-9;  // overlaps of touching faces that rounding makes [m]
  if (!contact.a.valid()) {
    std::swap(contact.a, contact.b);
    contact.impulse = -contact.impulse, contact.normal = -contact.normal;
  }
  const Side first = side_of(contact.a, contact.position, frame, scene);
  const Side second = side_of(contact.b, contact.position, frame, scene);
  const double along = contact.impulse.dot(contact.normal);
  const double across = (contact.impulse - along * contact.normal).norm();
  const Vec3 velocity = first.velocity - second.velocity;
  const double apart = velocity.dot(contact.normal), sliding = (velocity - apart * contact.normal).norm();
  SymbolReport report{"Contact", {}, {}};
  report.sentence = second.name + " pushed " + first.name + " with " +
                    format_quantity(contact.impulse.norm(), "N·s", 3) + " in this step, a mean force of " +
                    format_quantity(contact.impulse.norm() / duration, "N", 3) + ".";
  report.sentence[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(report.sentence[0])));
  report.rows = {{"Impulse on", first.name},
                 {"By", second.name},
                 {"Impulse", format_quantity(contact.impulse.norm(), "N·s", 3)},
                 {"Normal", direction_text(contact.normal)},
                 {"Normal force", format_quantity(along / duration, "N", 3)},
                 {"Friction force", format_quantity(across / duration, "N", 3)},
                 {"Friction / normal", along > 0 ? format_quantity(across / along, "", 3) : std::string("none")},
                 {"Overlap", contact.depth > kNoise ? format_quantity(contact.depth, "m", 3) : std::string("none")},
                 {"Approach speed", format_quantity(contact.approach, "m/s", 3)},
                 {"Separation speed", format_quantity(apart, "m/s", 3)},
                 {"Sliding speed", format_quantity(sliding, "m/s", 3)}};
  return report;
}

/// Rows of an axis of a symmetric tensor.
std::vector<SymbolReport::Row> axis_rows(const PrincipalValues& principal, int axis, const char* unit) {
  constexpr std::array kRanks = {"smallest", "middle", "largest"};
  return {{"Principal value", format_quantity(principal.values[axis], unit, 4)},
          {"Rank", kRanks[static_cast<std::size_t>(axis)]},
          {"Direction", direction_text(principal.directions.col(axis))}};
}

SymbolReport stress_report(const Symbol& symbol, const Frame& frame, const Scene& scene) {
  const TetId tet(symbol.index);
  const PrincipalValues principal = principal_values(frame.elements.stresses[tet]);
  const double value = principal.values[symbol.axis];
  SymbolReport report{"Principal stress", {}, axis_rows(principal, symbol.axis, "Pa")};
  report.sentence = "Element " + std::to_string(symbol.index) +
                    (value > 0 ? " is pulled along this axis with " : " is pressed along this axis with ") +
                    format_quantity(std::abs(value), "Pa", 3) + ", without shear across it.";
  report.rows.push_back({"Element", std::to_string(symbol.index)});
  report.rows.push_back({"Of", piece_text(frame, scene, frame.elements.bodies[tet])});
  return report;
}

SymbolReport separation_report(const Symbol& symbol, const Frame& frame, const Scene& scene) {
  const NodeId node(symbol.index);
  const NodeSeparation& separation = frame.nodes.separations[node];
  const PrincipalValues principal = principal_values(separation.tensor);
  const bool separates = symbol.axis == 2 && principal.values[2] > 0;
  SymbolReport report{"Separation axis", {}, axis_rows(principal, symbol.axis, "N")};
  const std::string name = "node " + std::to_string(symbol.index);
  report.sentence = separates
                        ? "Along this axis the forces separate " + name +
                              " most: it would crack across the plane perpendicular to it. Utilization " +
                              format_quantity(separation.utilization, "", 3) + "."
                        : "Along this axis the forces " +
                              std::string(principal.values[symbol.axis] > 0 ? "separate " : "press ") + name +
                              (principal.values[symbol.axis] > 0 ? " less than along the largest." : " together.");
  const BodyId body = frame.elements.bodies[frame.nodes.stars[node].front()];
  report.rows.push_back({"Node", std::to_string(symbol.index)});
  report.rows.push_back({"Of", piece_text(frame, scene, body)});
  return report;
}

template <class Items>
bool has(const Items& items, int index) {
  return index >= 0 && static_cast<std::size_t>(index) < items.size();
}

}  // namespace

std::optional<SymbolReport> symbol_report(const Symbol& symbol, const Frame& frame, const Scene& scene,
                                          double duration) {
  const auto index = static_cast<std::size_t>(symbol.index);
  switch (symbol.kind) {
    case SymbolKind::fracture_plane:
      if (has(frame.crack_events, symbol.index)) return plane_report(frame.crack_events[index], frame, scene);
      break;
    case SymbolKind::contact:
      if (has(frame.contacts, symbol.index)) return contact_report(frame.contacts[index], frame, scene, duration);
      break;
    case SymbolKind::stress_axis:
      if (has(frame.elements.stresses, symbol.index)) return stress_report(symbol, frame, scene);
      break;
    case SymbolKind::separation_axis:
      if (has(frame.nodes.separations, symbol.index)) return separation_report(symbol, frame, scene);
      break;
  }
  return std::nullopt;
}

}  // namespace griffith::ui
