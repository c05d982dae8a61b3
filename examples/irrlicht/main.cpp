// A scene of Griffith in a game engine: Irrlicht draws one mesh for each piece.
//
//     irrlicht_wall SCENE [PICTURE STEPS]      PICTURE: written after STEPS steps, then the program ends
#include <griffith/griffith.h>
#include <irrlicht.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <vector>

using namespace irr;

namespace {

void check(griffith_status status, const griffith_error& error) {
  if (status != GRIFFITH_OK) throw std::runtime_error(std::string(error.where) + ": " + error.problem);
}

/// A view of an array with entries of type T.
template <class T>
class View {
 public:
  View(const griffith_world* world, griffith_array_id id) {
    griffith_error error;
    check(griffith_world_array(world, id, &view_, &error), error);
  }
  int size() const { return static_cast<int>(view_.count); }
  T operator[](std::int64_t i) const {
    T value;
    std::memcpy(&value, static_cast<const char*>(view_.data) + i * view_.stride, sizeof(T));
    return value;
  }

 private:
  griffith_array view_;
};

struct Double3 {
  double x, y, z;
};
struct Double4 {
  double x, y, z, w;
};
struct Float3 {
  float x, y, z;
};
struct Int3 {
  std::int32_t a, b, c;
};

// Irrlicht is left-handed: z changes its sign.
core::vector3df to_engine(const Double3& v) { return {f32(v.x), f32(v.y), -f32(v.z)}; }
core::vector3df to_engine(const Float3& v) { return {v.x, v.y, -v.z}; }

/// Returns the angles of the mirrored rotation [degrees].
core::vector3df to_engine(const Double4& q) {
  core::vector3df angles;
  core::quaternion(-f32(q.x), -f32(q.y), f32(q.z), f32(q.w)).toEuler(angles);
  return angles * core::RADTODEG;
}

/// Pieces of a world as nodes of an engine's scene.
class Pieces {
 public:
  explicit Pieces(scene::ISceneManager& engine) : engine_(engine) {}

  void follow(griffith_world* world) {
    griffith_error error;
    check(griffith_world_update_surfaces(world, &error), error);
    const View<std::int32_t> versions(world, GRIFFITH_SURFACE_VERSIONS);
    const View<Double3> positions(world, GRIFFITH_BODY_POSITIONS);
    const View<Double4> turns(world, GRIFFITH_BODY_ORIENTATIONS);
    nodes_.resize(versions.size(), nullptr);
    versions_.resize(versions.size(), 0);
    for (int i = 0; i < versions.size(); ++i) {
      if (versions_[i] != versions[i]) upload(world, i);
      versions_[i] = versions[i];
      if (!nodes_[i]) continue;  // too small to own a splinter: invisible
      nodes_[i]->setPosition(to_engine(positions[i]));
      nodes_[i]->setRotation(to_engine(turns[i]));
    }
  }

 private:
  void upload(const griffith_world* world, int body) {
    const View<Float3> corners(world, GRIFFITH_SURFACE_POSITIONS), normals(world, GRIFFITH_SURFACE_NORMALS);
    const View<Int3> triangles(world, GRIFFITH_SURFACE_TRIANGLES);
    const View<std::uint8_t> is_crack(world, GRIFFITH_SURFACE_IS_CRACK);
    const int vertex = View<std::int32_t>(world, GRIFFITH_SURFACE_FIRST_VERTICES)[body];
    const int first = View<std::int32_t>(world, GRIFFITH_SURFACE_FIRST_TRIANGLES)[body];
    const int count = View<std::int32_t>(world, GRIFFITH_SURFACE_TRIANGLE_COUNTS)[body];
    auto* buffer = new scene::CDynamicMeshBuffer(video::EVT_STANDARD, video::EIT_32BIT);
    for (int t = first; t < first + count; ++t) {
      const video::SColor color = is_crack[t] ? video::SColor(255, 214, 150, 110) : video::SColor(255, 190, 90, 60);
      const Int3 triangle = triangles[t];
      for (const int corner : {triangle.a, triangle.c, triangle.b}) {  // a mirror image has the opposite orientation
        buffer->getVertexBuffer().push_back(
            video::S3DVertex(to_engine(corners[vertex + corner]), to_engine(normals[vertex + corner]), color, {}));
        buffer->getIndexBuffer().push_back(buffer->getIndexBuffer().size());
      }
    }
    buffer->recalculateBoundingBox();
    auto* mesh = new scene::SMesh();
    mesh->addMeshBuffer(buffer);
    buffer->drop();
    mesh->recalculateBoundingBox();
    if (nodes_[body]) nodes_[body]->remove();
    nodes_[body] = engine_.addMeshSceneNode(mesh);
    mesh->drop();
    nodes_[body]->getMaterial(0).ColorMaterial = video::ECM_DIFFUSE_AND_AMBIENT;
    nodes_[body]->getMaterial(0).SpecularColor = video::SColor(0);
  }

  scene::ISceneManager& engine_;
  std::vector<scene::IMeshSceneNode*> nodes_;  // per body
  std::vector<int> versions_;
};

/// Returns the bounding box of all nodes.
core::aabbox3df bounds_of(const griffith_world* world) {
  const View<Double3> nodes(world, GRIFFITH_NODE_POSITIONS);
  core::aabbox3df bounds(nodes.size() > 0 ? to_engine(nodes[0]) : core::vector3df());
  for (int i = 0; i < nodes.size(); ++i) bounds.addInternalPoint(to_engine(nodes[i]));
  return bounds;
}

/// Adds a camera in front of the box, above and to the right, and a light.
void add_camera_and_light(scene::ISceneManager& engine, const core::aabbox3df& bounds) {
  const f32 size = bounds.getExtent().getLength();
  engine.addCameraSceneNode(nullptr, bounds.getCenter() + size * core::vector3df(0.55f, 0.2f, -1), bounds.getCenter())
      ->setFarValue(20 * size);
  scene::ILightSceneNode* sun = engine.addLightSceneNode(nullptr, {}, video::SColorf(0.8f, 0.78f, 0.72f));
  sun->setLightType(video::ELT_DIRECTIONAL);
  sun->setRotation({50, -30, 0});
  engine.setAmbientLight(video::SColorf(0.3f, 0.32f, 0.36f));
}

void run(const char* path, const char* picture, int steps) {
  griffith_error error;
  griffith_scene* scene = nullptr;
  griffith_world* world = nullptr;
  check(griffith_scene_read(path, &scene, &error), error);
  check(griffith_world_create(scene, nullptr, &world, &error), error);
  griffith_scene_destroy(scene);

  IrrlichtDevice* device = createDevice(video::EDT_OPENGL, {960, 540}, 24);
  if (!device) throw std::runtime_error("Irrlicht: no window");
  scene::ISceneManager& engine = *device->getSceneManager();
  video::IVideoDriver& driver = *device->getVideoDriver();
  add_camera_and_light(engine, bounds_of(world));
  scene::IMesh* plane = engine.getGeometryCreator()->createPlaneMesh({40, 40}, {1, 1});
  engine.addMeshSceneNode(plane)->getMaterial(0).AmbientColor = video::SColor(255, 150, 155, 150);
  plane->drop();
  video::ITexture* canvas = driver.addRenderTargetTexture(driver.getScreenSize());
  Pieces pieces(engine);
  std::vector<scene::ISceneNode*> balls;

  for (int step = 0; device->run(); ++step) {
    if (step > 0) check(griffith_world_step(world, 1, &error), error);
    pieces.follow(world);
    const View<Double3> places(world, GRIFFITH_PROJECTILE_POSITIONS);
    const View<double> radii(world, GRIFFITH_PROJECTILE_RADII);
    for (int i = static_cast<int>(balls.size()); i < places.size(); ++i)
      balls.push_back(engine.addSphereSceneNode(f32(radii[i]), 32));
    for (int i = 0; i < places.size(); ++i) balls[i]->setPosition(to_engine(places[i]));
    const bool last = picture && step == steps;
    const video::SColor sky(255, 168, 188, 205);
    driver.beginScene(true, true, sky);
    if (last) driver.setRenderTarget(canvas, true, true, sky);  // the pixels of a window may not be readable
    engine.drawAll();
    driver.endScene();
    if (!last) continue;
    video::IImage* image = driver.createImage(canvas, {0, 0}, canvas->getSize());
    const bool written = image && driver.writeImageToFile(image, picture);
    if (image) image->drop();
    if (!written) throw std::runtime_error(std::string(picture) + ": cannot be written");
    break;
  }
  device->drop();
  griffith_world_destroy(world);
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2 && argc != 4) {
    std::fprintf(stderr, "usage: %s SCENE [PICTURE STEPS]\n", argv[0]);
    return 2;
  }
  run(argv[1], argc == 4 ? argv[2] : nullptr, argc == 4 ? std::atoi(argv[3]) : 0);
} catch (const std::exception& problem) {
  std::fprintf(stderr, "%s\n", problem.what());
  return 1;
}
