#pragma once

#include "sim/scene/field.h"
#include "sim/scene/quantities.h"
#include "sim/scene/scene.h"
#include "sim/scene/view_names.h"

// Fields of cameras and views, a part of the table in scene_fields.h.

namespace griffith {

template <class Archive>
void describe(Archive& archive, Camera& camera) {
  archive.field("name", camera.name, Text{1}, "Name, different from every other camera's");
  archive.field("position", camera.position, kPlace, "Position of the camera");
  archive.field("target", camera.target, kPlace, "Point that it looks at");
  archive.field("field_of_view_degrees", camera.field_of_view_degrees, between(5, 120, "degrees"),
                "Vertical angle of view");
  archive.require(camera.position != camera.target, "target", "is the camera's own position",
                  "move the target or the position");
}

template <class Archive>
void describe(Archive& archive, SlicePlane& slice) {
  archive.field("normal", slice.normal, kDirection, "Normal toward the hidden side; any length but 0");
  archive.field("offset", slice.offset, kPlace, "Distance of the plane from the origin along the normal");
}

template <class Archive>
void describe(Archive& archive, ViewSettings& view) {
  Numbers range = between(-1e15, 1e15);
  range.ascending = true;
  const OneOf quantities = {keys_of(view_quantities()), {{"margin", "utilization"}}};
  OneOf layers;
  for (const ViewLayerInfo& layer : view_layers()) layers.names.push_back(layer.key);
  const auto maps = color_map_names(), styles = element_style_names(), qualities = picture_quality_names();
  archive.field("quantity", view.quantity, quantities, "Quantity shown by colors");
  archive.field(
      "color_map", view.color_map, OneOf{{maps.begin(), maps.end()}},
      "Colors from low to high; automatic: coolwarm about 0 for signed quantities, heat for utilization, else "
      "viridis");
  archive.field("range", view.range, range,
                "Values at the two ends of the colors, in the quantity's unit; null: automatic");
  archive.field("symmetric", view.symmetric, Flag{}, "The automatic range extends equally below and above 0");
  archive.field("quality", view.quality, OneOf{{qualities.begin(), qualities.end()}},
                "Light and effects: draft is the fastest; standard and high have soft shadows, ambient occlusion and "
                "transparent glass");
  archive.field("shading", view.shading, Flag{},
                "Scalars are shaded by light; without, a pixel has exactly the legend's color");
  archive.field("edges", view.edges, Flag{},
                "Element edges are drawn, except where splinters replace tetrahedra in natural colors");
  archive.field("edge_width", view.edge_width, between(0.25, 10),
                "Width of element edges, in pixels of a picture 720 pixels high");
  archive.field("splinters", view.splinters, Flag{}, "Splinters and surfaces are drawn in place of the tetrahedra");
  archive.field("dust", view.dust, Flag{},
                "Cracks emit dust and crumbs in natural colors: an effect, not in draft quality");
  archive.field("elements", view.elements, OneOf{{styles.begin(), styles.end()}},
                "Style of tetrahedra: the surface, all edges, or each one separately and smaller");
  archive.field("deformation_scale", view.deformation_scale, between(0, 1e6, "-"),
                "Magnification of the drawn deformation of pieces");
  archive.field("explode", view.explode, between(0, 20, "-"),
                "Extra distance of drawn pieces from the center, relative to their own");
  archive.field("opacity", view.opacity, between(0.05, 1, "-"), "Opacity of bodies");
  archive.field("slice", view.slice, Parts{}, "Plane that cuts the drawn bodies; null: none");
  archive.field("layers", view.layers, layers, "Layers drawn besides the bodies");
  archive.field("fracture_planes", view.fracture_planes, between(1, 1000000),
                "Number of cracks whose planes the layer `fracture_planes` shows, newest first");
  archive.field("glyph_scale", view.glyph_scale, between(0.01, 100, "-"), "Size of arrows and other symbols");
}

}  // namespace griffith
