#include "app/output/crack_event_file.h"

#include <nlohmann/json.hpp>

#include "app/shared/components.h"

namespace griffith::app {
namespace {

using Json = nlohmann::ordered_json;

Json element_json(const CrackElement& element) {
  return {{"tet", element.tet.index()},
          {"above", element.above},
          {"tensile", components(element.force.tensile)},
          {"compressive", components(element.force.compressive)}};
}

Json event_json(const CrackEvent& event) {
  Json json = {{"step", event.step}, {"time", event.time}, {"body", event.body.index()}};
  json["children"] = Json::array();
  for (BodyId child : event.children) json["children"].push_back(child.index());
  json["node"] = event.node.index();
  json["position"] = components(event.position);
  json["rest_position"] = components(event.rest_position);
  json["normal"] = components(event.normal);
  json["eigenvalue"] = event.eigenvalue;
  json["load"] = event.load;
  json["resistance"] = event.resistance;
  json["scale_factor"] = event.scaled ? event.scaled->factor : 1;
  if (event.scaled) json["scaled_because"] = reason(*event.scaled);
  json["nodes_made"] = event.nodes_made;
  json["torn_off"] = event.torn_off;
  json["elements"] = Json::array();
  for (const CrackElement& element : event.elements) json["elements"].push_back(element_json(element));
  return json;
}

}  // namespace

std::string crack_events_json(const Frame& frame) {
  Json events = Json::array();
  for (const CrackEvent& event : frame.crack_events) events.push_back(event_json(event));
  return events.dump(1) + "\n";
}

}  // namespace griffith::app
