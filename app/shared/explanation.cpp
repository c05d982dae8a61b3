#include "app/shared/explanation.h"

#include <cstdio>

#include "sim/fracture/fracture_law.h"
#include "sim/world/output/node_report.h"
#include "ui/model/units.h"
#include "ui/model/verdict.h"

namespace griffith::app {
namespace {

std::string newtons(double force) { return ui::format_quantity(force, "N"); }

std::string load_line(const NodeReport& report, const Material& material) {
  return "  now " + ui::format_quantity(report.load, fracture_law(material).unit) + ": " +
         ui::origin_of_load(report, material) + ", plane across (" + ui::direction_text(report.normal()) + ")\n";
}

std::string element_lines(const NodeReport& report) {
  const char* unit = ui::contribution_unit(report);
  std::string text = "  element    side    contribution       tensile force    compressive force\n";
  for (const ElementContribution& element : report.elements) {
    char line[160];
    std::snprintf(line, sizeof line, "  %7d    %-5s   %16s %16s %20s\n", element.tet.index(),
                  element.above ? "above" : "below", ui::format_quantity(element.contribution, unit).c_str(),
                  newtons(element.force.tensile.norm()).c_str(), newtons(element.force.compressive.norm()).c_str());
    text += line;
  }
  if (report.balance != 0) text += "  unbalanced force " + newtons(report.balance) + "\n";
  return text + "  total " + ui::format_quantity(report.sum(), unit) + "\n";
}

}  // namespace

std::string explanation(const Frame& frame, NodeId node, bool fracture) {
  const NodeReport report = node_report(frame, node);
  const NodeSeparation& separation = report.separation;
  const Material& material = frame.materials[frame.bodies[report.body].scene_body];
  const std::string_view unit = fracture_law(material).unit;
  std::string text = "Node " + std::to_string(node.index()) + ", step " + std::to_string(frame.step) + ", " +
                     ui::format_quantity(frame.time, "s") + "\n" + ui::verdict_on(report, frame, fracture).text + "\n";
  if (!report.strained) return text;
  text += "  load " + ui::format_quantity(ui::load_of(separation, material), unit) + ", resistance " +
          ui::resistance_text(separation, material) + ", utilization " +
          ui::format_quantity(separation.utilization, "") + "\n";
  text += load_line(report, material);
  text += "  eigenvalues of the separation tensor " + newtons(report.principal.values[2]) + ", " +
          newtons(report.principal.values[1]) + ", " + newtons(report.principal.values[0]) + "\n";
  return text + element_lines(report);
}

}  // namespace griffith::app
