#pragma once

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/color.h"

namespace griffith::render {

using Weights = Eigen::Matrix<float, 4, 1, Eigen::DontAlign>;  ///< barycentric weights of a tet's corners

/// Direction of a normal carried by a tet: proportional to its products with the three edges from the tet's first point
/// to the others, at rest. All 0: none, the polygon is flat.
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
  std::array<std::int16_t, 4> products_ = {};  ///< the last one is padding
};

/// A corner of a polygon carried by tets. Its position is the mean of a tet's points with one of two sets of
/// barycentric weights: those in its own tet or, if another tet carries its part, those in the other one.
struct EmbeddedCorner {
  Eigen::Vector3f rest = Eigen::Vector3f::Zero();  ///< rest position [m], to which noise is fixed
  Weights weights = Weights::Zero(), other_weights = Weights::Zero();
  std::int32_t tet = 0;                          ///< its own tet
  std::int32_t part = 0;                         ///< index into EmbeddedSurface::carriers
  std::int32_t piece = 0;                        ///< index into EmbeddedSurface::piece_colors
  std::int32_t style = 0;                        ///< EmbeddedStyle
  CarriedNormal normal = {}, other_normal = {};  ///< in its own tet and in the other one
  Eigen::Vector2f uv = Eigen::Vector2f::Zero();
};

/// Appearance of a polygon, packed.
struct EmbeddedStyle {
  int material = 0;       ///< index into EmbeddedSurface::materials, below 2^16
  int tet_face = -1;      ///< 0..3: face of its tet in which it lies, whose edges are drawn; -1: none
  bool inner = false;     ///< opened by fracture
  bool textured = false;  ///< its corners have texture coordinates

  std::int32_t packed() const { return material | (tet_face + 1) << 16 | int(inner) << 20 | int(textured) << 21; }
};

/// A convex polygon: a range of corners.
struct EmbeddedPolygon {
  std::int32_t first_corner = 0, corners = 0;
};

/// Polygons carried by tets; kept on the device as long as the same mesh is drawn.
struct EmbeddedMesh {
  std::vector<EmbeddedCorner> corners;
  std::vector<EmbeddedPolygon> polygons;
  std::vector<std::int32_t> outer;  ///< polygons that are always drawn
};

/// Structure of a material, visible on fracture surfaces or dressed faces, from standard quality on.
enum class Grain {
  none,
  stones,    ///< rounded stones of three sizes in a matrix
  clay,      ///< small grains and pores
  sand,      ///< like stones, of similar tones
  crystals,  ///< several minerals, one dark
  facets,    ///< crystals of one kind
  veins,     ///< the same, with dark veins through them
  rings,     ///< growth rings with fibers
  bricks,    ///< bricks in running bond with mortar
  cast       ///< smooth, with faint stones and pores
};

/// Appearance of a material if no scalar is shown.
struct EmbeddedMaterial {
  Rgb color = {0.7f, 0.7f, 0.7f};
  float variation = 0;                              ///< relative variation of brightness between pieces
  float mottle = 0;                                 ///< relative variation of brightness within a piece
  float roughness = 0;                              ///< perturbation of the normal, as a slope
  float noise_size = 0.05f;                         ///< scale of mottle and roughness [m]
  Eigen::Vector3f fiber = Eigen::Vector3f::Zero();  ///< direction times √(1 − 1/elongation) of noise along it
  float clear_depth = 0;                            ///< distance over which light takes the color [m]; 0: opaque
  Grain grain = Grain::none;
  float grain_size = 0.02f;  ///< size of its largest parts [m]
  bool dressed = false;      ///< shows its grain on outer polygons too
  float gloss = 0;           ///< strength of what the surface mirrors, 0..1, from standard quality on
  float blur = 0.05f;        ///< roughness of the mirroring surface, 0..1
  float metal = 0;           ///< 1: mirrors light in its color
};

/// Embedded polygons in their current state. Nothing is drawn without a mesh.
struct EmbeddedSurface {
  std::shared_ptr<const EmbeddedMesh> mesh;
  std::vector<Eigen::Vector3f> points;            ///< world frame [m]
  std::vector<std::array<std::int32_t, 4>> tets;  ///< indices into `points`; a triangle's id is its own tet
  std::vector<std::int32_t> carriers;             ///< per part: the tet that carries it
  std::vector<std::int32_t> opened;               ///< polygons that are drawn in addition to the outer ones
  std::vector<float> scalars;                     ///< shown by Surface::scalar_style; may be empty
  bool scalars_per_point = false;                 ///< true for one scalar per point, false for one per tet
  std::vector<Rgb> piece_colors;                  ///< per piece, if there are no scalars; otherwise materials are shown
  std::vector<EmbeddedMaterial> materials;
  bool closed = false;             ///< the polygons enclose bodies, like the triangles of a closed Surface
  bool checker = false;            ///< textured polygons show squares of a sixteenth of their texture
  std::int32_t selected_tet = -1;  ///< highlighted
};

}  // namespace griffith::render
