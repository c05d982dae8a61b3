#include "app/export/usda_file.h"

#include "app/export/pose_keys.h"
#include "app/export/usda_text.h"
#include "sim/core/number_text.h"

namespace griffith::app {
namespace {

/// Writes "<frame>: <text of the key>" for each key, the form of time samples.
template <class Text>
void append_samples(UsdaText& usda, const std::string& attribute, const BakedObject& object, const Text& text) {
  usda.open(attribute + " =");
  for (const int key : pose_keys(object))
    usda.line(std::to_string(object.first_frame + key) + ": " + text(object.poses[key]) + ",");
  usda.close();
}

std::string orientation(const Pose& pose) {
  const Quat& q = pose.rotation;
  return usda_tuple({q.w(), q.x(), q.y(), q.z()});
}

std::string translation(const Pose& pose) { return usda_tuple(pose.translation); }

void append_motion(UsdaText& usda, const BakedObject& object) {
  append_samples(usda, "double3 xformOp:translate.timeSamples", object, translation);
  append_samples(usda, "quatf xformOp:orient.timeSamples", object, orientation);
  usda.line(R"(uniform token[] xformOpOrder = ["xformOp:translate", "xformOp:orient"])");
  if (object.first_frame == 0) return;
  usda.open("token visibility.timeSamples =");
  usda.line("0: \"invisible\",");
  usda.line(std::to_string(object.first_frame) + ": \"inherited\",");
  usda.close();
}

void append_properties(UsdaText& usda, const BakedObject& object) {
  usda.line("custom double griffith:mass = " + number_text(object.mass));
  usda.line("custom bool griffith:isSupported = " + std::to_string(object.is_supported));
  usda.line("custom int griffith:sceneBody = " + std::to_string(object.scene_body));
  if (object.break_time) usda.line("custom double griffith:breakTime = " + number_text(*object.break_time));
  if (object.broke_scaled)
    usda.line("custom double griffith:scaleFactor = " + number_text(object.broke_scaled->factor));
}

void append_corners(std::string& text, const std::vector<std::array<int, 3>>& triangles) {
  for (const std::array<int, 3>& triangle : triangles)
    for (const int corner : triangle) text += (text.empty() ? "" : ", ") + std::to_string(corner);
}

std::string consecutive(std::size_t first, std::size_t count) {
  std::string text;
  for (std::size_t i = first; i < first + count; ++i) text += (i > first ? ", " : "") + std::to_string(i);
  return '[' + text + ']';
}

void append_subset(UsdaText& usda, const std::string& name, const std::string& faces, const std::string& material) {
  usda.open("def GeomSubset \"" + name + "\" (prepend apiSchemas = [\"MaterialBindingAPI\"])");
  usda.line(R"(uniform token elementType = "face")");
  usda.line(R"(uniform token familyName = "materialBind")");
  usda.line("int[] indices = " + faces);
  usda.line("rel material:binding = </World/Materials/" + material + ">");
  usda.close();
}

void append_deformation(UsdaText& usda, const BakedObject& object) {
  if (object.deformed_points.empty()) return;
  usda.open("point3f[] points.timeSamples =");
  for (std::size_t i = 0; i < object.deformed_points.size(); ++i)
    usda.line(std::to_string(static_cast<std::size_t>(object.first_frame) + i) + ": " +
              usda_array(object.deformed_points[i]) + ",");
  usda.close();
}

void append_mesh(UsdaText& usda, const BakedObject& object, const std::vector<BakedMaterial>& materials) {
  const BakedMesh& mesh = object.mesh;
  std::string counts, corners;
  for (const std::vector<std::array<int, 3>>& triangles : mesh.triangles) {
    for (std::size_t i = 0; i < triangles.size(); ++i) counts += counts.empty() ? "3" : ", 3";
    append_corners(corners, triangles);
  }
  Eigen::AlignedBox3d box;
  for (const Vec3& point : mesh.points) box.extend(point);
  usda.open("def Mesh \"surface\"");
  usda.line(R"(uniform token subdivisionScheme = "none")");
  usda.line("float3[] extent = [" + usda_tuple(box.min()) + ", " + usda_tuple(box.max()) + "]");
  usda.line("int[] faceVertexCounts = [" + counts + "]");
  usda.line("int[] faceVertexIndices = [" + corners + "]");
  usda.line("point3f[] points = " + usda_array(mesh.points));
  append_deformation(usda, object);
  usda.line("normal3f[] normals = " + usda_array(mesh.normals) + " (interpolation = \"vertex\")");
  usda.line("texCoord2f[] primvars:st = " + usda_array(mesh.uvs) + " (interpolation = \"vertex\")");
  constexpr const char* kSubsets[kLooks] = {"outside", "inside", "mortar"};
  std::size_t first = 0;
  for (int look = 0; look < kLooks; ++look) {
    const std::size_t count = mesh.triangles[look].size();
    if (count > 0)
      append_subset(usda, kSubsets[look], consecutive(first, count), materials[object.materials[look]].name);
    first += count;
  }
  usda.close();
}

void append_object(UsdaText& usda, const BakedObject& object, const std::vector<BakedMaterial>& materials) {
  usda.open("def Xform \"" + object.name + "\"");
  append_motion(usda, object);
  append_properties(usda, object);
  append_mesh(usda, object, materials);
  usda.close();
}

void append_material(UsdaText& usda, const BakedMaterial& material) {
  usda.open("def Material \"" + material.name + "\"");
  usda.line("token outputs:surface.connect = </World/Materials/" + material.name + "/shader.outputs:surface>");
  usda.open("def Shader \"shader\"");
  usda.line(R"(uniform token info:id = "UsdPreviewSurface")");
  usda.line("color3f inputs:diffuseColor = " + usda_tuple(material.color));
  usda.line("float inputs:metallic = 0");
  usda.line("float inputs:opacity = " + number_text(material.opacity));
  usda.line("float inputs:roughness = " + number_text(material.roughness));
  usda.line("token outputs:surface");
  usda.close();
  usda.close();
}

/// Writes the bonds as one prim of arrays, one element for each bond.
void append_bonds(UsdaText& usda, const Bake& bake) {
  std::vector<Vec3> centers, normals;
  std::string from, to, areas, strengths, break_times;
  const auto append = [](std::string& list, const std::string& entry) { list += (list.empty() ? "" : ", ") + entry; };
  for (const BakedBond& bond : bake.bonds) {
    append(from, '"' + bake.objects[bond.a].name + '"');
    append(to, '"' + bake.objects[bond.b].name + '"');
    append(areas, number_text(bond.area));
    append(strengths, number_text(bond.strength));
    append(break_times, bond.break_time ? number_text(*bond.break_time) : "inf");
    centers.push_back(bond.center);
    normals.push_back(bond.normal);
  }
  usda.open("def Scope \"Bonds\"");
  usda.line("custom string[] griffith:a = [" + from + "]");
  usda.line("custom string[] griffith:b = [" + to + "]");
  usda.line("custom double[] griffith:area = [" + areas + "]");
  usda.line("custom double[] griffith:strength = [" + strengths + "]");
  usda.line("custom double[] griffith:breakTime = [" + break_times + "]");
  usda.line("custom float3[] griffith:center = " + usda_array(centers));
  usda.line("custom float3[] griffith:normal = " + usda_array(normals));
  usda.close();
}

}  // namespace

std::string usda_file(const Bake& bake) {
  UsdaText usda(bake.frames_per_second, static_cast<int>(bake.times.size()) - 1);
  usda.open("def Xform \"World\"");
  usda.open("def Scope \"Materials\"");
  for (const BakedMaterial& material : bake.materials) append_material(usda, material);
  usda.close();
  for (const BakedObject& object : bake.objects) append_object(usda, object, bake.materials);
  append_bonds(usda, bake);
  usda.close();
  return usda.text();
}

}  // namespace griffith::app
