#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <fstream>
#include <span>

#include "sim/error.h"
#include "sim/meshing/polygon.h"
#include "sim/meshing/surface.h"

namespace griffith {
namespace {

constexpr std::array kFormats = {".obj", ".stl", ".ply", ".off", ".gltf", ".glb"};

/// Assimp's reader of PLY files never ends where the header does not.
void require_ply_header(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("end_header")) return;
  throw InputError(path.string(), "cannot be read: its header has no end", "a line \"end_header\" is missing");
}

void require_known_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) throw InputError(path.string(), "no such file", "check the path");
  if (!std::filesystem::is_regular_file(path, ignored))
    throw InputError(path.string(), "is no file", "name the surface's file itself");
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return std::tolower(c); });
  if (std::find(kFormats.begin(), kFormats.end(), extension) == kFormats.end())
    throw InputError(path.string(), "is no surface format known here", ".obj, .stl, .ply, .off, .gltf or .glb");
  if (std::filesystem::file_size(path, ignored) == 0)
    throw InputError(path.string(), "is empty", "export the surface again");
  if (extension == ".ply") require_ply_header(path);
}

Vec3 vector_of(const aiVector3D& v) { return Vec3(v.x, v.y, v.z); }

/// Adds a triangle of vertices of `mesh`; corners without a normal or a place in the texture get zeros.
void add_triangle(const aiMesh& mesh, int first_point, const std::array<unsigned, 3>& vertices,
                  TriangleSurface& surface) {
  auto& triangle = surface.triangles.emplace_back();
  auto& uv = surface.uvs.emplace_back();
  auto& normal = surface.normals.emplace_back();
  for (int corner = 0; corner < 3; ++corner) {
    const unsigned vertex = vertices[corner];
    triangle[corner] = first_point + static_cast<int>(vertex);
    uv[corner] = mesh.HasTextureCoords(0) ? Vec2(vector_of(mesh.mTextureCoords[0][vertex]).head<2>()) : Vec2(0, 0);
    normal[corner] = mesh.HasNormals() ? vector_of(mesh.mNormals[vertex]) : Vec3(0, 0, 0);
  }
}

/// Adds the faces of `mesh`. (Assimp's own way of cutting polygons ends the program where they are degenerate.)
void add_mesh(const aiMesh& mesh, TriangleSurface& surface) {
  const int first_point = static_cast<int>(surface.points.size());
  for (unsigned i = 0; i < mesh.mNumVertices; ++i) surface.points.push_back(vector_of(mesh.mVertices[i]));
  for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
    const std::span<const unsigned> face(mesh.mFaces[i].mIndices, mesh.mFaces[i].mNumIndices);
    std::vector<Vec3> corners;
    for (const unsigned vertex : face) corners.push_back(vector_of(mesh.mVertices[vertex]));
    for (const auto& [a, b, c] : triangulate(corners))  // none for points and lines
      add_triangle(mesh, first_point, {face[a], face[b], face[c]}, surface);
  }
}

TriangleSurface surface_of(const aiScene& scene) {
  TriangleSurface surface;
  bool has_uvs = false, has_normals = false;
  for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
    add_mesh(*scene.mMeshes[i], surface);
    has_uvs = has_uvs || scene.mMeshes[i]->HasTextureCoords(0);
    has_normals = has_normals || scene.mMeshes[i]->HasNormals();
  }
  if (!has_uvs) surface.uvs.clear();
  if (!has_normals) surface.normals.clear();
  return surface;
}

void require_known_vertices(const aiScene& scene, const std::filesystem::path& path) {
  for (const aiMesh* mesh : std::span(scene.mMeshes, scene.mNumMeshes))
    for (const aiFace& face : std::span(mesh->mFaces, mesh->mNumFaces))
      for (const unsigned vertex : std::span(face.mIndices, face.mNumIndices))
        if (vertex >= mesh->mNumVertices)
          throw InputError(path.string(), "has a face with a corner that does not exist", "export the surface again");
}

void require_finite(const TriangleSurface& surface, const std::filesystem::path& path) {
  for (std::size_t i = 0; i < surface.triangles.size(); ++i)
    for (const Vec3& corner : corners_of(surface, static_cast<int>(i)))
      if (!corner.allFinite())
        throw InputError(path.string(), "triangle " + std::to_string(i) + " has a coordinate that is not finite",
                         "export the surface again; look for nan and inf in the file");
}

/// Throws InputError where Assimp cannot read the file.
const aiScene& read_scene(Assimp::Importer& importer, const std::filesystem::path& path) {
  const aiScene* scene = importer.ReadFile(path.string(), aiProcess_PreTransformVertices);
  if (scene != nullptr) return *scene;
  throw InputError(path.string(), std::string("cannot be read: ") + importer.GetErrorString(),
                   "check that the file's content is what its ending says");
}

}  // namespace

TriangleSurface read_surface(const std::filesystem::path& path, double scale) {
  require_known_file(path);
  Assimp::Importer importer;
  const aiScene& scene = read_scene(importer, path);
  require_known_vertices(scene, path);
  TriangleSurface surface = surface_of(scene);
  if (surface.triangles.empty())
    throw InputError(path.string(), "holds no triangles", "export the surface's faces, not its points or lines alone");
  for (Vec3& point : surface.points) point *= scale;
  require_finite(surface, path);
  weld_points(surface);
  return surface;
}

}  // namespace griffith
