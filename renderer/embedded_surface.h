#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/color.h"

namespace griffith::render {

using Weights = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;  ///< barycentric, of a tet's corners

/// The direction of a normal that a tet carries: in proportion to its products with the three edges from the tet's
/// first point to the others, before anything moved. All 0: none, the polygon is flat.
class CarriedNormal {
 public:
  CarriedNormal() = default;
  explicit CarriedNormal(const Eigen::Vector3f& products) {
    constexpr float kLargest = 32767;
    const float scale = products.cwiseAbs().maxCoeff();
    if (!(scale > 0)) return;
    for (int i = 0; i < 3; ++i) products_[i] = static_cast<std::int16_t>(std::lround(kLargest * products[i] / scale));
  }

 private:
  std::array<std::int16_t, 4> products_ = {};  ///< the last one fills up
};

/// A corner of a polygon that tets carry. Its place is the mean of a tet's points with one of two sets of barycentric
/// weights: those in its own tet, or, where another tet carries its part, those in that other one.
struct EmbeddedCorner {
  Eigen::Vector3f rest = Eigen::Vector3f::Zero();  ///< where it was before anything moved [m]: noise sticks to it
  Weights weights = Weights::Zero(), other_weights = Weights::Zero();
  std::int32_t tet = 0;                          ///< its own
  std::int32_t part = 0;                         ///< which entry of EmbeddedSurface::carriers holds for it
  std::int32_t piece = 0;                        ///< which entry of EmbeddedSurface::piece_colors holds for it
  std::int32_t style = 0;                        ///< EmbeddedStyle
  CarriedNormal normal = {}, other_normal = {};  ///< in its own tet and in the other one
  Eigen::Vector2f uv = Eigen::Vector2f::Zero();
};

/// What a polygon looks like, packed.
struct EmbeddedStyle {
  int material = 0;       ///< index into EmbeddedSurface::materials, below 2^16
  int tet_face = -1;      ///< 0..3: the face of its tet in which it lies, whose edges are drawn; -1: none
  bool inner = false;     ///< made by fracture
  bool textured = false;  ///< its corners have places in a texture

  std::int32_t packed() const { return material | (tet_face + 1) << 16 | int(inner) << 20 | int(textured) << 21; }
};

/// A convex polygon: some corners, one after the other.
struct EmbeddedPolygon {
  std::int32_t first_corner = 0, corners = 0;
};

/// Polygons carried by tets; kept on the device as long as the same mesh is drawn.
struct EmbeddedMesh {
  std::vector<EmbeddedCorner> corners;
  std::vector<EmbeddedPolygon> polygons;
  std::vector<std::int32_t> outer;  ///< the polygons that are always drawn
};

/// What a matter is made of, seen where it broke or was dressed, from standard quality on.
enum class Grain {
  none,
  stones,    ///< rounded stones of three sizes in a matrix
  clay,      ///< small grains and pores
  sand,      ///< as stones, of like tones
  crystals,  ///< of several minerals, one dark
  facets,    ///< crystals of one kind
  veins,     ///< the same, with dark veins through them
  rings      ///< of growth, with fibres
};

/// The look of a matter where no scalar is shown.
struct EmbeddedMaterial {
  Rgb color = {0.7f, 0.7f, 0.7f};
  float variation = 0;                              ///< of brightness from piece to piece, as a share
  float mottle = 0;                                 ///< of brightness within a piece, as a share
  float roughness = 0;                              ///< how far the normal is turned about, as a slope
  float noise_size = 0.05f;                         ///< of mottle and roughness [m]
  Eigen::Vector3f fibre = Eigen::Vector3f::Zero();  ///< direction times √(1 − 1/stretch) of noise along it
  float clear_depth = 0;  ///< how far light comes through before it has the colour [m]; 0: not at all
  Grain grain = Grain::none;
  float grain_size = 0.02f;  ///< of its largest parts [m]
  bool dressed = false;      ///< its grain is seen on outer polygons too
  float gloss = 0;           ///< of a glaze that mirrors sky and lamp, 0..1, from standard quality on
};

/// Embedded polygons as they are now. Nothing is drawn without a mesh.
struct EmbeddedSurface {
  std::shared_ptr<const EmbeddedMesh> mesh;
  std::vector<Eigen::Vector3f> points;            ///< world frame [m]
  std::vector<std::array<std::int32_t, 4>> tets;  ///< indices into `points`; a triangle's id is its own tet
  std::vector<std::int32_t> carriers;             ///< per part: the tet that carries it
  std::vector<std::int32_t> opened;               ///< polygons that are drawn besides the outer ones
  std::vector<float> scalars;                     ///< shown by Surface::scalar_style; may be empty
  bool scalars_per_point = false;                 ///< of `scalars`: one a point, else one a tet
  std::vector<Rgb> piece_colors;                  ///< per piece, where there are no scalars; else materials are shown
  std::vector<EmbeddedMaterial> materials;
  bool closed = false;             ///< the polygons bound bodies, as the triangles of a closed Surface do
  bool checker = false;            ///< textured polygons show squares of a sixteenth of their texture
  std::int32_t selected_tet = -1;  ///< highlighted
};

}  // namespace griffith::render
