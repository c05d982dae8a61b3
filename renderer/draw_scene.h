#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "renderer/color.h"
#include "renderer/color_map.h"
#include "renderer/embedded_surface.h"

namespace griffith::render {

/// Id of objects that cannot be picked: background, ground, and anything without an id.
inline constexpr std::int32_t kNoId = -1;

/// Bits of Surface::flags.
enum TriangleFlag : std::uint8_t {
  kEdge0 = 1 << 0,  ///< draw the edge opposite corner 0 (from corner 1 to 2)
  kEdge1 = 1 << 1,  ///< draw the edge opposite corner 1
  kEdge2 = 1 << 2,  ///< draw the edge opposite corner 2
  kAllEdges = kEdge0 | kEdge1 | kEdge2,
  kCrackFace = 1 << 3,  ///< opened by fracture: darker and warmer if no scalar is shown
  kSelected = 1 << 4,   ///< highlighted
  kPlain = 1 << 5,      ///< in its plain color although the surface has scalars
  kClear = 1 << 6,      ///< transparent, from standard quality on
};

/// Mapping from Surface::scalars to colors, with the texts of the legend.
struct ScalarStyle {
  ColorMap color_map = ColorMap::viridis;
  float minimum = 0, maximum = 1;   ///< values of the map's two ends; minimum < maximum
  std::string quantity, unit;       ///< for the legend, e.g. "largest principal stress", "Pa"
  std::vector<int> histogram = {};  ///< for the legend: counts of values in equal parts of the range
  bool has_nan = false;             ///< for the legend: some values are not numbers
  std::string plain = {};           ///< for the legend: meaning of the plain color; empty: it has none
};

/// Triangles with data per corner or per triangle. Everything but `positions` may be empty. Front faces are
/// counterclockwise; both sides are drawn, unless the triangles are `closed`.
struct Surface {
  std::vector<Eigen::Vector3f> positions;  ///< 3 per triangle, world frame [m]
  std::vector<float> scalars;              ///< 1 per triangle or 3 per triangle (interpolated); shown by scalar_style
  std::vector<Rgb> colors;                 ///< 1 per triangle, instead of `color`; used without scalars
  std::vector<std::int32_t> ids;           ///< 1 per triangle, for picking
  std::vector<std::uint8_t> flags;         ///< 1 per triangle: TriangleFlag bits; none if empty
  /// 1 per triangle: index into EmbeddedSurface::materials whose grain is shown over the color, without scalars and
  /// from standard quality on; negative: none.
  std::vector<std::int32_t> matters;
  std::vector<Eigen::Vector3f> rests;  ///< 3 per triangle, with `matters`: positions at rest [m]
  ScalarStyle scalar_style;
  Rgb color = {0.74f, 0.77f, 0.80f};
  float clear_depth = 0.1f;  ///< kClear triangles: distance over which light takes their color [m], > 0
  /// True if the triangles enclose bodies, with their fronts outside: backs are then not drawn from outside.
  bool closed = false;
  float opacity = 1;  ///< opacity of this and the embedded surface, 0..1; the selection stays opaque
};

/// Half-space of the points x with normal · x <= offset.
struct HalfSpace {
  Eigen::Vector3f normal = Eigen::Vector3f::UnitZ();  ///< unit length
  float offset = 0;                                   ///< [m]
};

/// A scaled and rotated unit solid, the image of
///   arrow  from the origin to (1, 0, 0), its head of radius 1 about the x axis
///   ball   of radius 1
///   disc   of radius 1 about the x axis, without thickness
///   box    from (−1, −1, −1) to (1, 1, 1)
struct Glyph {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();    ///< image of the unit solid's origin [m]
  Eigen::Matrix3f axes = Eigen::Matrix3f::Identity();  ///< columns: images of the unit axes [m]
  Rgb color = {0.85f, 0.40f, 0.25f};
  float opacity = 1;  ///< 0..1
  std::int32_t id = kNoId;
};

/// Any number of glyphs, drawn in one call per shape.
struct Glyphs {
  std::vector<Glyph> arrows, balls, discs, boxes;
};

struct Sphere {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();  ///< [m]
  float radius = 1;                                  ///< [m]
  Rgb color = {0.85f, 0.40f, 0.25f};
  std::int32_t id = kNoId;
  float metal = 0;         ///< 1: mirrors light in its color, from standard quality on
  float roughness = 0.3f;  ///< blur of what it mirrors, 0..1
  float mottle = 0;        ///< strength of the grain of stone, 0..1
  Eigen::Matrix<float, 4, 1, Eigen::DontAlign> rotation = {0, 0, 0, 1};  ///< quaternion x, y, z, w; turns the grain
};

/// A soft cloud, denser toward its center.
struct Puff {
  Eigen::Vector3f center = Eigen::Vector3f::Zero();  ///< [m]
  float radius = 1;                                  ///< [m]
  Rgb color = {0.7f, 0.7f, 0.7f};
  float opacity = 0.5f;  ///< opacity of the center, 0..1
};

/// A line of DrawScene::line_width pixels.
struct Line {
  Eigen::Vector3f start = Eigen::Vector3f::Zero(), end = Eigen::Vector3f::Zero();  ///< [m]
  Rgb color = {0.1f, 0.1f, 0.1f};
  std::int32_t id = kNoId;
};

/// A round dot of a fixed size on the screen.
struct Point {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< [m]
  float diameter = 6;                                  ///< [pixels]
  Rgb color = {0.1f, 0.1f, 0.1f};
  std::int32_t id = kNoId;
};

/// A short text at a point, to be drawn over the picture by the caller.
struct Label {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();  ///< [m]
  std::string text;
  float rise = 0;  ///< height of its center above the point [heights of a line]
};

/// A horizontal plane that receives shadows, with a grid that shows the scale (GridLevel).
struct Ground {
  float height = 0;  ///< y of the plane [m]
  Rgb color = {0.36f, 0.355f, 0.35f};
  /// False: only its extent matters. Depths of objects are rounded as in a picture with it, so that where two of them
  /// meet, both pictures show the same one.
  bool drawn = true;
};

/// Surroundings made of formulas: they light objects and are mirrored by them, from standard quality on.
struct Environment {
  enum class Kind {
    studio,  ///< a gray room with a lamp, two softboxes and a window
    sky      ///< a clear sky with a sun
  };
  Kind kind = Kind::studio;
  float strength = 1;  ///< factor on all light but the lamp's or the sun's, >= 0
};

/// A gradient from the horizon up, or the sky of the environment.
struct Background {
  Rgb top = {0.15f, 0.16f, 0.18f}, bottom = {0.43f, 0.435f, 0.44f};
  bool is_sky = false;  ///< shows the environment from standard quality on; the gradient is that of drafts
};

/// Content of a picture as plain data; the renderer knows nothing else about the world.
struct DrawScene {
  Surface surface;
  EmbeddedSurface embedded;
  std::vector<Sphere> spheres;
  std::vector<Sphere> crumbs;  ///< chips, which affect neither framing nor the extent of shadows
  std::vector<Puff> puffs;     ///< like crumbs
  std::vector<Line> lines;
  std::vector<Point> points;
  Glyphs glyphs;
  std::vector<Label> labels;
  float line_width = 2;              ///< [pixels]
  std::optional<HalfSpace> visible;  ///< part of surface and embedded surface that is drawn
  std::optional<Ground> ground;
  Environment environment;
  Background background;
};

/// Returns the bounding box of everything but the ground; empty for an empty scene. Positions that are not finite are
/// ignored.
Eigen::AlignedBox3f bounds(const DrawScene& scene);

}  // namespace griffith::render
