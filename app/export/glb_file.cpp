#include "app/export/glb_file.h"

#include <sstream>
#include <stdexcept>

#include "app/export/glb_buffer.h"
#include "app/export/pose_keys.h"

namespace griffith::app {
namespace {

using tinygltf::Value;

std::vector<double> components(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

tinygltf::Material gltf_material(const BakedMaterial& baked) {
  tinygltf::Material material;
  material.name = baked.name;
  material.pbrMetallicRoughness.baseColorFactor = {baked.color.x(), baked.color.y(), baked.color.z(), baked.opacity};
  material.pbrMetallicRoughness.metallicFactor = 0;
  material.pbrMetallicRoughness.roughnessFactor = baked.roughness;
  if (baked.opacity < 1) material.alphaMode = "BLEND";
  return material;
}

/// Adds morph targets: the displacements of each frame's points from those of the mesh.
std::vector<std::map<std::string, int>> morph_targets(const BakedObject& object, GlbBuffer& buffer) {
  std::vector<std::map<std::string, int>> targets;
  for (const std::vector<Vec3>& points : object.deformed_points) {
    std::vector<Vec3> offsets(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) offsets[i] = points[i] - object.mesh.points[i];
    targets.push_back({{"POSITION", buffer.add_vectors(offsets, true)}});
  }
  return targets;
}

tinygltf::Mesh gltf_mesh(const BakedObject& object, GlbBuffer& buffer) {
  tinygltf::Primitive primitive;
  primitive.mode = TINYGLTF_MODE_TRIANGLES;
  primitive.attributes = {{"POSITION", buffer.add_vectors(object.mesh.points, true)},
                          {"NORMAL", buffer.add_vectors(object.mesh.normals, false)},
                          {"TEXCOORD_0", buffer.add_uvs(object.mesh.uvs)}};
  primitive.targets = morph_targets(object, buffer);
  tinygltf::Mesh mesh;
  mesh.name = object.name;
  mesh.weights.resize(object.deformed_points.size());
  for (int look = 0; look < kLooks; ++look) {
    if (object.mesh.triangles[look].empty()) continue;
    primitive.material = object.materials[look];
    primitive.indices = buffer.add_indices(object.mesh.triangles[look]);
    mesh.primitives.push_back(primitive);
  }
  return mesh;
}

Value bond_extras(const Bake& bake, const BakedBond& bond, int object) {
  Value::Object extras = {{"to", Value(bake.objects[object == bond.a ? bond.b : bond.a].name)},
                          {"area", Value(bond.area)},
                          {"strength", Value(bond.strength)}};
  if (bond.break_time) extras["break_time"] = Value(*bond.break_time);
  return Value(extras);
}

/// Returns custom properties. `bonds`: of the object.
Value object_extras(const Bake& bake, int index, std::span<const BakedBond* const> bonds) {
  const BakedObject& object = bake.objects[index];
  Value::Object extras = {{"mass", Value(object.mass)},
                          {"scene_body", Value(object.scene_body)},
                          {"is_supported", Value(object.is_supported)}};
  if (object.break_time) extras["break_time"] = Value(*object.break_time);
  if (object.broke_scaled) extras["scale_factor"] = Value(object.broke_scaled->factor);
  Value::Array list;
  for (const BakedBond* bond : bonds) list.push_back(bond_extras(bake, *bond, index));
  if (!list.empty()) extras["bonds"] = Value(list);
  return Value(extras);
}

tinygltf::Node gltf_node(const BakedObject& object, int mesh) {
  tinygltf::Node node;
  node.name = object.name;
  node.mesh = mesh;
  const Pose& pose = object.poses.front();
  node.translation = components(pose.translation);
  node.rotation = {pose.rotation.x(), pose.rotation.y(), pose.rotation.z(), pose.rotation.w()};
  return node;
}

/// Adds tracks to the animation of the file.
class AnimationWriter {
 public:
  AnimationWriter(const Bake& bake, GlbBuffer& buffer) : bake_(bake), buffer_(buffer) { animation_.name = "run"; }

  void add_motion(const BakedObject& object, int node) {
    const std::vector<int> keys = pose_keys(object);
    if (keys.size() < 2) return;
    std::vector<double> times;
    std::vector<Vec3> positions;
    std::vector<Quat> rotations;
    for (const int key : keys) {
      times.push_back(time(object.first_frame + key));
      positions.push_back(object.poses[key].translation);
      rotations.push_back(object.poses[key].rotation);
    }
    const int input = buffer_.add_key_times(times);
    add_track(node, "translation", input, buffer_.add_key_vectors(positions), "LINEAR");
    add_track(node, "rotation", input, buffer_.add_key_rotations(rotations), "LINEAR");
  }

  void add_appearance(const BakedObject& object, int node) {
    if (object.first_frame == 0) return;
    const std::vector<double> times = {0, time(object.first_frame)};
    const std::vector<Vec3> scales = {Vec3::Zero(), Vec3::Ones()};
    add_track(node, "scale", buffer_.add_key_times(times), buffer_.add_key_vectors(scales), "STEP");
  }

  /// Adds a track that gives each frame its own morph target.
  void add_deformation(const BakedObject& object, int node) {
    const std::size_t frames = object.deformed_points.size();
    if (frames < 2) return;
    std::vector<double> times;
    std::vector<float> weights(frames * frames);
    for (std::size_t i = 0; i < frames; ++i) {
      times.push_back(time(object.first_frame + static_cast<int>(i)));
      weights[i * frames + i] = 1;
    }
    add_track(node, "weights", buffer_.add_key_times(times), buffer_.add_key_numbers(weights), "LINEAR");
  }

  tinygltf::Animation finish() { return std::move(animation_); }

 private:
  double time(int frame) const { return bake_.times[frame] - bake_.times.front(); }

  void add_track(int node, const char* path, int input, int output, const char* interpolation) {
    tinygltf::AnimationSampler sampler;
    sampler.input = input;
    sampler.output = output;
    sampler.interpolation = interpolation;
    tinygltf::AnimationChannel channel;
    channel.sampler = static_cast<int>(animation_.samplers.size());
    channel.target_node = node;
    channel.target_path = path;
    animation_.samplers.push_back(sampler);
    animation_.channels.push_back(channel);
  }

  const Bake& bake_;
  GlbBuffer& buffer_;
  tinygltf::Animation animation_;
};

std::vector<std::vector<const BakedBond*>> bonds_by_object(const Bake& bake) {
  std::vector<std::vector<const BakedBond*>> bonds(bake.objects.size());
  for (const BakedBond& bond : bake.bonds)
    for (const int object : {bond.a, bond.b}) bonds[object].push_back(&bond);
  return bonds;
}

std::string written(tinygltf::Model& model) {
  std::ostringstream stream(std::ios::binary);
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, stream, false, true))
    throw std::runtime_error("the scene could not be written as glTF");
  return std::move(stream).str();
}

}  // namespace

std::string glb_file(const Bake& bake) {
  tinygltf::Model model;
  GlbBuffer buffer;
  AnimationWriter animation(bake, buffer);
  tinygltf::Scene scene;
  scene.name = bake.scene_name;
  for (const BakedMaterial& material : bake.materials) model.materials.push_back(gltf_material(material));
  const std::vector<std::vector<const BakedBond*>> bonds = bonds_by_object(bake);
  for (int i = 0; i < std::ssize(bake.objects); ++i) {
    const BakedObject& object = bake.objects[i];
    model.meshes.push_back(gltf_mesh(object, buffer));
    model.nodes.push_back(gltf_node(object, i));
    model.nodes.back().extras = object_extras(bake, i, bonds[i]);
    scene.nodes.push_back(i);
    animation.add_motion(object, i);
    animation.add_appearance(object, i);
    animation.add_deformation(object, i);
  }
  buffer.finish(model);
  if (tinygltf::Animation all = animation.finish(); !all.channels.empty()) model.animations.push_back(std::move(all));
  model.scenes.push_back(scene);
  model.defaultScene = 0;
  model.asset.version = "2.0";
  model.asset.generator = "Griffith";
  return written(model);
}

}  // namespace griffith::app
