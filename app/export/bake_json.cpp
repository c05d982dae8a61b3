#include "app/export/bake_json.h"

#include <nlohmann/json.hpp>

namespace griffith::app {
namespace {

using Json = nlohmann::ordered_json;

Json json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Json json(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

Json thing_json(const BakedThing& thing) {
  return {{"name", thing.name},
          {"scene_body", thing.scene_body},
          {"mass", thing.mass},
          {"center", json(thing.poses.front().translation)},
          {"is_supported", thing.is_supported},
          {"break_time", json(thing.break_time)},
          {"scale_factor", thing.broke_scaled ? thing.broke_scaled->factor : 1}};
}

Json bond_json(const Bake& bake, const BakedBond& bond) {
  return {{"a", bake.things[bond.a].name},      {"b", bake.things[bond.b].name}, {"area", bond.area},
          {"center", json(bond.center)},        {"normal", json(bond.normal)},   {"strength", bond.strength},
          {"break_time", json(bond.break_time)}};
}

}  // namespace

std::string bake_json(const Bake& bake) {
  Json document = {{"scene", bake.scene_name},
                   {"start", bake.times.front()},
                   {"end", bake.times.back()},
                   {"things", Json::array()},
                   {"bonds", Json::array()}};
  for (const BakedThing& thing : bake.things) document["things"].push_back(thing_json(thing));
  for (const BakedBond& bond : bake.bonds) document["bonds"].push_back(bond_json(bake, bond));
  return document.dump(2) + '\n';
}

}  // namespace griffith::app
