#include <assimp/DefaultIOSystem.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <exception>
#include <new>
#include <span>

#include "sim/core/error.h"
#include "sim/core/file_path.h"
#include "sim/geometry/polygon.h"
#include "sim/meshing/surface_objects.h"

namespace griffith {
namespace {

/// Gives Assimp only the surface itself and regular files in or below its folder. A file from a stranger may name any
/// path for its buffers, and opening a pipe could block forever.
class FilesOfSurface : public Assimp::DefaultIOSystem {
 public:
  explicit FilesOfSurface(std::filesystem::path surface) : surface_(std::move(surface)) {}

  bool Exists(const char* file) const override {
    std::error_code ignored;
    return std::filesystem::is_regular_file(file, ignored);
  }
  Assimp::IOStream* Open(const char* file, const char* mode) override {
    if (!Exists(file)) return nullptr;
    const bool allowed = file == surface_ || is_within(surface_.parent_path(), file);
    if (!allowed) refused_ = file;
    return allowed ? Assimp::DefaultIOSystem::Open(file, mode) : nullptr;
  }
  /// Returns the last existing file that was refused; empty if there was none.
  const std::string& refused() const { return refused_; }

 private:
  std::filesystem::path surface_;
  std::string refused_;
};

/// Rethrows std::bad_alloc, which Assimp catches like its own errors.
void rethrow_bad_alloc(const Assimp::Importer& importer) try {
  if (const std::exception_ptr error = importer.GetException()) std::rethrow_exception(error);
} catch (const std::bad_alloc&) {
  throw;
} catch (...) {
  // The importer's error text reports it.
}

Vec3 vector_of(const aiVector3D& v) { return Vec3(v.x, v.y, v.z); }

/// Transformation of a mesh in its file.
struct Placement {
  aiMatrix4x4 points;
  aiMatrix3x3 normals;

  explicit Placement(const aiMatrix4x4& transformation) : points(transformation), normals(transformation) {
    normals.Inverse().Transpose();
  }
  Vec3 normal(const aiVector3D& n) const {
    const Vec3 turned = vector_of(normals * n);
    return turned.norm() > 0 ? Vec3(turned.normalized()) : Vec3(Vec3::Zero());
  }
};

/// Adds a triangle of vertices of `mesh`. Corners without a normal or texture coordinates get zeros.
void add_triangle(const aiMesh& mesh, const Placement& placement, int first_point,
                  const std::array<unsigned, 3>& vertices, TriangleSurface& surface) {
  auto& triangle = surface.triangles.emplace_back();
  auto& uv = surface.uvs.emplace_back();
  auto& normal = surface.normals.emplace_back();
  for (int corner = 0; corner < 3; ++corner) {
    const unsigned vertex = vertices[corner];
    triangle[corner] = first_point + static_cast<int>(vertex);
    uv[corner] = mesh.HasTextureCoords(0) ? Vec2(vector_of(mesh.mTextureCoords[0][vertex]).head<2>()) : Vec2(0, 0);
    normal[corner] = mesh.HasNormals() ? placement.normal(mesh.mNormals[vertex]) : Vec3(0, 0, 0);
  }
}

/// Adds the faces of `mesh`. (Assimp's own triangulation ends the program for degenerate polygons.)
void add_mesh(const aiMesh& mesh, const Placement& placement, TriangleSurface& surface) {
  const int first_point = static_cast<int>(surface.points.size());
  for (unsigned i = 0; i < mesh.mNumVertices; ++i)
    surface.points.push_back(vector_of(placement.points * mesh.mVertices[i]));
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const std::span<const unsigned> face(mesh.mFaces[i].mIndices, mesh.mFaces[i].mNumIndices);
    std::vector<Vec3> corners;
    for (const unsigned vertex : face) corners.push_back(surface.points[first_point + vertex]);
    for (const auto& [a, b, c] : triangulate(corners))  // none for points and lines
      add_triangle(mesh, placement, first_point, {face[a], face[b], face[c]}, surface);
  }
}

/// Adds one object for the meshes of a node, then those of its children.
void add_objects(const aiScene& scene, const aiNode& node, const aiMatrix4x4& parent,
                 std::vector<SurfaceObject>& objects) {
  const aiMatrix4x4 transformation = parent * node.mTransformation;
  if (node.mNumMeshes > 0) {
    SurfaceObject& object = objects.emplace_back();
    object.name = node.mName.C_Str();
    bool has_uvs = false, has_normals = false;
    for (const unsigned index : std::span(node.mMeshes, node.mNumMeshes)) {
      const aiMesh& mesh = *scene.mMeshes[index];
      add_mesh(mesh, Placement(transformation), object.surface);
      has_uvs = has_uvs || mesh.HasTextureCoords(0);
      has_normals = has_normals || mesh.HasNormals();
    }
    if (!has_uvs) object.surface.uvs.clear();
    if (!has_normals) object.surface.normals.clear();
  }
  for (const aiNode* child : std::span(node.mChildren, node.mNumChildren))
    add_objects(scene, *child, transformation, objects);
}

void require_known_vertices(const aiScene& scene, const std::filesystem::path& path) {
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes))
    for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces))
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices))
        if (vertex >= mesh->mNumVertices)
          throw InputError(path.string(), "has a face with a corner that does not exist", "export the surface again");
}

}  // namespace

std::vector<SurfaceObject> import_objects(const std::filesystem::path& path) {
  Assimp::Importer importer;
  auto* const files = new FilesOfSurface(path);
  importer.SetIOHandler(files);  // the importer owns it
  const aiScene* scene = importer.ReadFile(path.string(), 0);
  rethrow_bad_alloc(importer);
  if (scene == nullptr && !files->refused().empty())
    throw InputError(path.string(), "needs the file \"" + files->refused() + "\", which is outside its folder",
                     "put it beside the surface: files named by a surface are only read from its folder");
  if (scene == nullptr || scene->mRootNode == nullptr)
    throw InputError(path.string(), std::string("cannot be read: ") + importer.GetErrorString(),
                     "check that the file's content matches its suffix");
  require_known_vertices(*scene, path);
  std::vector<SurfaceObject> objects;
  add_objects(*scene, *scene->mRootNode, aiMatrix4x4(), objects);
  std::string extension = path.extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  if (extension == ".stl")  // its normals are those of facets and would hide that the surface is smooth
    for (SurfaceObject& object : objects) object.surface.normals.clear();
  return objects;
}

}  // namespace griffith
