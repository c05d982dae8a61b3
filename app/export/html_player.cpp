#include "app/export/html_player.h"

#include <bit>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "app/export/player_files.h"
#include "app/output/html_page.h"

namespace griffith::app {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "browsers read numbers as they lie in memory");

/// Buffer of consecutive four-byte numbers.
template <class Number>
class Numbers {
 public:
  template <class Vector>
  void add_components(const Vector& vector) {
    for (const auto component : vector) values_.push_back(static_cast<Number>(component));
  }
  std::string text() const {
    return base64({reinterpret_cast<const char*>(values_.data()), values_.size() * sizeof(Number)});
  }

 private:
  static_assert(sizeof(Number) == 4);
  std::vector<Number> values_;
};

/// Arrays counted in the header, in its order.
struct Arrays {
  Numbers<float> floats;
  Numbers<std::uint32_t> indices;
};

Json header_json(const std::optional<double>& time) { return time ? Json(*time) : Json(nullptr); }
Json header_json(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

Vec3 size_of(const BakedMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.points) box.extend(point);
  return box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.sizes());
}

void add_arrays(const BakedObject& object, Arrays& arrays) {
  for (const Vec3& point : object.mesh.points) arrays.floats.add_components(point);
  for (const Vec3& normal : object.mesh.normals) arrays.floats.add_components(normal);
  for (const Pose& pose : object.poses) {
    arrays.floats.add_components(pose.translation);
    arrays.floats.add_components(pose.rotation.coeffs());
  }
  for (const std::vector<Vec3>& points : object.deformed_points)
    for (const Vec3& point : points) arrays.floats.add_components(point);
  for (const auto& triangles : object.mesh.triangles)
    for (const std::array<int, 3>& triangle : triangles) arrays.indices.add_components(triangle);
}

Json triangle_counts(const BakedMesh& mesh) {
  Json counts = Json::array();
  for (const auto& triangles : mesh.triangles) counts.push_back(triangles.size());
  return counts;
}

Json object_json(const BakedObject& object, Arrays& arrays) {
  add_arrays(object, arrays);
  return {{"name", object.name},
          {"body", object.scene_body < 0 ? Json(nullptr) : Json(object.scene_body)},
          {"mass", object.mass},
          {"size", header_json(size_of(object.mesh))},
          {"supported", object.is_supported},
          {"breakTime", header_json(object.break_time)},
          {"brokeScaled", object.broke_scaled ? Json(scale_text(*object.broke_scaled)) : Json(nullptr)},
          {"materials", object.materials},
          {"firstFrame", object.first_frame},
          {"pointCount", object.mesh.points.size()},
          {"poseCount", object.poses.size()},
          {"deformedCount", object.deformed_points.size()},
          {"triangleCounts", triangle_counts(object.mesh)}};
}

Json material_json(const BakedMaterial& material) {
  return {{"name", material.name},
          {"color", header_json(material.color)},
          {"opacity", material.opacity},
          {"roughness", material.roughness}};
}

Json bond_json(const BakedBond& bond) {
  return {{"a", bond.a},
          {"b", bond.b},
          {"area", bond.area},
          {"strength", bond.strength},
          {"breakTime", header_json(bond.break_time)}};
}

Json header(const Bake& bake, Arrays& arrays) {
  Json header = {{"scene", bake.scene_name}, {"framesPerSecond", bake.frames_per_second}, {"times", bake.times}};
  for (const char* list : {"bodies", "materials", "objects", "bonds"}) header[list] = Json::array();
  for (const std::string& name : bake.body_names) header["bodies"].push_back(name);
  for (const BakedMaterial& material : bake.materials) header["materials"].push_back(material_json(material));
  for (const BakedObject& object : bake.objects) header["objects"].push_back(object_json(object, arrays));
  for (const BakedBond& bond : bake.bonds) header["bonds"].push_back(bond_json(bond));
  return header;
}

/// Returns a data element of a page. Text that would end the element is escaped, which JSON allows and base64 does not
/// need.
std::string data_element(const std::string& id, const std::string& text) {
  std::string safe;
  for (const char c : text) c == '<' ? safe += "\\u003c" : safe += c;
  return "<script type=\"application/octet-stream\" id=\"" + id + "\">" + safe + "</script>\n";
}

std::string script_element(const char* script) { return std::string("<script>\n") + script + "</script>\n"; }

}  // namespace

std::string html_player(const Bake& bake) {
  Arrays arrays;
  const Json all = header(bake, arrays);
  std::string body = player_files::player_html;
  body += data_element("bake", all.dump(-1, ' ', false, Json::error_handler_t::replace));
  body += data_element("floats", arrays.floats.text());
  body += data_element("indices", arrays.indices.text());
  for (const char* script :
       {player_files::player_bake_js, player_files::player_camera_js, player_files::player_shaders_js,
        player_files::player_view_js, player_files::player_panel_js, player_files::player_main_js})
    body += script_element(script);
  return html_page(bake.scene_name, std::string("<style>\n") + player_files::player_css + "</style>\n", body);
}

}  // namespace griffith::app
