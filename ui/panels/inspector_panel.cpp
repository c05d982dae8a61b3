#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "sim/elasticity/principal_stress.h"
#include "sim/fracture/fracture_law.h"
#include "ui/model/units.h"
#include "ui/model/verdict.h"
#include "ui/panels/panels.h"
#include "ui/widgets/style.h"
#include "ui/widgets/utilization_plot.h"
#include "ui/widgets/widgets.h"

namespace griffith::ui {
namespace {

constexpr std::size_t kMaxElements = 8, kMaxEvents = 4;  // most rows of each list

/// Formats three values with the prefix of the largest: "3.02, -1.85, -12.7 kPa".
std::string triple(const Vec3& values, const char* unit) {
  const double largest = values.cwiseAbs().maxCoeff();
  const SiPrefix prefix = si_prefix(largest, unit);
  const auto shown = [&](double value) { return std::abs(value) < 1e-9 * largest ? 0 : value / prefix.factor; };
  char text[96];
  std::snprintf(text, sizeof text, "%.3g, %.3g, %.3g ", shown(values[0]), shown(values[1]), shown(values[2]));
  return text + std::string(prefix.symbol) + unit;
}

void verdict_line(const Panel& panel, const Verdict& verdict) {
  constexpr std::array kColors = {palette::kGood,   palette::kWarning, palette::kError,
                                  palette::kAccent, palette::kTextDim, palette::kWarning};
  wrapped_text(verdict.text, kColors[static_cast<std::size_t>(verdict.kind)]);
  tag_last_item(panel.tags, "inspector/verdict", verdict.text);
}

/// Shows load, resistance and utilization.
void utilization_rows(const Panel& panel, const NodeReport& report, const Material& material) {
  const NodeSeparation& separation = report.separation;
  const std::string_view unit = fracture_law(material).unit;
  value_row(panel, "Load", format_quantity(load_of(separation, material), unit), palette::kText);
  tooltip("Mean over the last substeps, from which the utilization is computed: a short peak breaks nothing.");
  value_row(panel, "Resistance", resistance_text(separation, material), palette::kText);
  value_row(panel, "Utilization", format_quantity(separation.utilization, "", 3),
            separation.utilization > 0.8 ? palette::kWarning : palette::kText);
}

/// Shows the separation tensor, which compares elements with each other: that of a single element is zero.
void tensor_rows(const Panel& panel, const NodeReport& report) {
  if (report.elements.size() == 1 && report.principal.values.isZero(0)) {
    value_row(panel, "Eigenvalues", "none: one element", palette::kTextDim);
    tooltip(
        "The separation tensor compares the elements of a node. This node has only one, whose tensile stress is the "
        "load.");
    return;
  }
  value_row(panel, "Eigenvalues", triple(Vec3(report.principal.values.reverse()), "N"), palette::kText);
  tooltip("Eigenvalues of the separation tensor, largest first: the separating forces along its three axes.");
  value_row(panel, "Top eigenvector", direction_text(report.principal.directions.col(2)), palette::kText);
}

/// Shows the load at the time of the frame, from its own stresses.
void load_rows(const Panel& panel, const NodeReport& report, const Material& material) {
  value_row(panel, "Load now", format_quantity(report.load, fracture_law(material).unit), palette::kText);
  hint(panel, origin_of_load(report, material));
  tag_last_item(panel.tags, "inspector/origin", origin_of_load(report, material));
  value_row(panel, "Plane normal", direction_text(report.normal()), palette::kText);
  tensor_rows(panel, report);
}

/// Shows load, resistance, tensor and plane of the crack of the next step.
void coming_crack_rows(Panel& panel, const ComingCrack& coming, const Material& material) {
  hint(panel, "When it cracks:");
  draw_utilization_bar(panel, coming.utilization());
  const std::string_view unit = fracture_law(material).unit;
  value_row(panel, "Load at the crack", format_quantity(coming.load, unit), palette::kText);
  value_row(panel, "Resistance then", format_quantity(coming.resistance, unit), palette::kText);
  value_row(panel, "Utilization then", format_quantity(coming.utilization(), "", 3), palette::kError);
  value_row(panel, "Crack plane normal", direction_text(coming.normal), palette::kText);
  value_row(panel, "Eigenvalues then", triple(coming.eigenvalues, "N"), palette::kText);
  tooltip("Eigenvalues of the separation tensor under which the crack opens, largest first.");
  hint(panel, "Now, before that:");
}

/// Formats a contribution, which is 0 if it is a rounding error of the forces that add up to it.
std::string contribution_text(const NodeReport& report, double contribution) {
  constexpr double kRoundOff = 1e-9;
  double largest = 0;  // of the forces [N]; tensions are sums of one sign
  for (const ElementContribution& element : report.elements)
    largest = std::max({largest, element.force.tensile.norm(), element.force.compressive.norm()});
  const bool is_noise = !report.by_tension && std::abs(contribution) < kRoundOff * largest;
  return format_quantity(is_noise ? 0 : contribution, contribution_unit(report), 3);
}

/// Draws one ranked element; a click selects it.
void element_row(Panel& panel, const NodeReport& report, std::size_t rank) {
  const ElementContribution& element = report.elements[rank];
  char text[96];
  std::snprintf(text, sizeof text, "%zu   element %d, %s", rank + 1, element.tet.index(),
                element.above ? "above" : "below");
  const bool selected = panel.state.selection.tet == element.tet;
  if (ImGui::Selectable((std::string(text) + "##share").c_str(), selected)) panel.state.selection.tet = element.tet;
  const std::string contribution = contribution_text(report, element.contribution);
  tag_last_item(panel.tags, "inspector/element/" + std::to_string(rank), contribution);
  tooltip("Tensile force " + format_quantity(element.force.tensile.norm(), "N", 3) + " along " +
          direction_text(element.force.tensile.normalized()) + "\nCompressive force " +
          format_quantity(element.force.compressive.norm(), "N", 3) + " along " +
          direction_text(element.force.compressive.normalized()));
  ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - ImGui::CalcTextSize(contribution.c_str()).x);
  ImGui::TextColored(as_vec4(element.contribution > 0 ? palette::kAccent : palette::kTextDim), "%s",
                     contribution.c_str());
}

void contribution_rows(Panel& panel, const NodeReport& report) {
  hint(panel, "Contributions of the elements, largest first:");
  const std::size_t listed = std::min(report.elements.size(), kMaxElements);
  for (std::size_t i = 0; i < listed; ++i) element_row(panel, report, i);
  double others = 0;
  for (std::size_t i = listed; i < report.elements.size(); ++i) others += report.elements[i].contribution;
  if (listed < report.elements.size())
    value_row(panel, (std::to_string(report.elements.size() - listed) + " more elements").c_str(),
              contribution_text(report, others), palette::kText);
  if (report.balance != 0) {
    value_row(panel, "Unbalanced force", contribution_text(report, report.balance), palette::kText);
    tooltip(
        "Contribution of the sums of the tensile and compressive forces, which is subtracted: balanced forces pull the "
        "node apart, an unbalanced one accelerates it.");
  }
  value_row(panel, "Total", contribution_text(report, report.sum()), palette::kText);
}

void event_rows(const Panel& panel, const NodeReport& report) {
  const Frame& frame = panel.input.frame;
  const std::size_t first = report.events.size() - std::min(report.events.size(), kMaxEvents);
  for (std::size_t i = first; i < report.events.size(); ++i) {
    const CrackEvent& event = frame.crack_events[report.events[i]];
    const std::string text = "step " + std::to_string(step_of(event)) + ", " + format_quantity(event.time, "s", 3) +
                             ", utilization " + format_quantity(event.load / event.resistance, "", 3);
    value_row(panel, "Crack", text, palette::kAccent);
    tooltip("Plane " + direction_text(event.normal) + ", " + std::to_string(event.elements.size()) + " elements, " +
            std::to_string(event.nodes_made) + " nodes created");
  }
}

const char* state_of(const BodyView& body) {
  if (body.asleep) return "asleep";
  return body.rigid ? "rigid" : "elastic";
}

/// Describes the piece that a body broke off and the time of its first crack: "piece 0, 26.8 ms".
std::string origin_of(const BodyView& body, const Frame& frame) {
  std::string text = "piece " + std::to_string(body.parent.index());
  const auto parted = std::ranges::find_if(frame.crack_events, [&](const CrackEvent& crack) {
    return std::ranges::find(crack.children, body.id) != crack.children.end();
  });
  return parted == frame.crack_events.end() ? text : text + ", " + format_quantity(parted->time, "s", 3);
}

void element_rows(const Panel& panel, TetId tet) {
  const Frame& frame = panel.input.frame;
  const Mat3& stress = frame.elements.stresses[tet];
  const BodyView& body = frame.bodies[frame.elements.bodies[tet]];
  value_row(panel, "Element", std::to_string(tet.index()), palette::kText);
  value_row(panel, "Von Mises stress", format_quantity(von_mises_stress(stress), "Pa"), palette::kText);
  value_row(panel, "Principal stresses", triple(principal_stresses(stress), "Pa"), palette::kText);
  if (body.rigid) hint(panel, "frozen when the piece became rigid");
  value_row(panel, "Piece", std::to_string(body.id.index()) + ", " + format_quantity(body.mass, "kg", 3),
            palette::kText);
  value_row(panel, "Its state", state_of(body), palette::kText);
  if (body.parent.valid()) value_row(panel, "Broke off", origin_of(body, frame), palette::kText);
  value_row(panel, "Its elements", std::to_string(body.tets), palette::kText);
  value_row(panel, "Speed", format_quantity(body.velocity.norm(), "m/s", 3), palette::kText);
  if (!body.broke_scaled) return;
  value_row(panel, "Piece broke at", scale_text(*body.broke_scaled), palette::kWarning);
  tooltip(stand_in_text(*body.broke_scaled));
}

}  // namespace

void draw_inspector_panel(Panel& panel) {
  heading(panel, "Why it broke or holds");
  const Frame& frame = panel.input.frame;
  const Selection& selection = panel.state.selection;
  if (!selection.valid() || static_cast<std::size_t>(selection.node) >= frame.nodes.positions.size()) {
    const bool strained = std::ranges::any_of(frame.bodies, [](const BodyView& body) { return !body.rigid; });
    hint(panel, "Click a node in the view, or press M for the most loaded one.");
    if (!strained && !frame.bodies.empty()) hint(panel, std::string("Now ") + kNothingStrained);
    return;
  }
  const NodeReport report = node_report(frame, selection.node);
  const BodyView& body = frame.bodies[report.body];
  const bool fracture = panel.history.scene().simulation.fracture, in_step = panel.state.microsteps.has_value();
  verdict_line(panel, verdict_on(report, frame, fracture, panel.state.stop, in_step));
  const Material& material = frame.materials[body.scene_body];
  const std::optional<ComingCrack> coming = node_state(report, frame, panel.state.stop).coming;
  if (coming) coming_crack_rows(panel, *coming, material);
  if (report.strained && !coming) draw_utilization_bar(panel, report.separation.utilization);
  draw_utilization_plot(panel, panel.input.utilizations);
  value_row(panel, "Node", std::to_string(report.node.index()), palette::kText);
  if (report.strained) utilization_rows(panel, report, material);
  event_rows(panel, report);
  if (report.strained) {
    load_rows(panel, report, material);
    contribution_rows(panel, report);
  }
  element_rows(panel, selection.tet);
}

}  // namespace griffith::ui
