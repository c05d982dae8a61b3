#include "app/export/bake_json.h"

#include <nlohmann/json.hpp>

namespace griffith::app {
namespace {

using Json = nlohmann::ordered_json;

Json json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Json json(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

Json object_json(const BakedObject& object) {
  return {{"name", object.name},
          {"scene_body", object.scene_body},
          {"mass", object.mass},
          {"center", json(object.poses.front().translation)},
          {"is_supported", object.is_supported},
          {"break_time", json(object.break_time)},
          {"scale_factor", object.broke_scaled ? object.broke_scaled->factor : 1}};
}

Json bond_json(const Bake& bake, const BakedBond& bond) {
  return {{"a", bake.objects[bond.a].name},     {"b", bake.objects[bond.b].name}, {"area", bond.area},
          {"center", json(bond.center)},        {"normal", json(bond.normal)},    {"strength", bond.strength},
          {"break_time", json(bond.break_time)}};
}

}  // namespace

std::string bake_json(const Bake& bake) {
  Json document = {{"scene", bake.scene_name},
                   {"start", bake.times.front()},
                   {"end", bake.times.back()},
                   {"objects", Json::array()},
                   {"bonds", Json::array()}};
  for (const BakedObject& object : bake.objects) document["objects"].push_back(object_json(object));
  for (const BakedBond& bond : bake.bonds) document["bonds"].push_back(bond_json(bake, bond));
  return document.dump(2) + '\n';
}

}  // namespace griffith::app
