#pragma once

#include "app/picture/draw_scene_from_frame.h"
#include "sim/core/copy_on_write.h"

namespace griffith::app {

/// What a picture shows of a frame: equal ones, equal pictures of it.
struct PictureSettings {
  Scene scene;  ///< what the world was built from, with the materials that it has now
  ViewSettings view;
  ui::Selection selection;
  HiddenBodies hidden;
  bool operator==(const PictureSettings&) const = default;
};

/// A picture that is made of the next step, on any thread: a value that knows all but that step.
struct StepPicture {
  PictureSettings settings;
  CopyOnWrite<EmbeddedDisplay> display;  ///< as the steps before have left it
  SteadyRange range;                     ///< the same
  render::DrawScene drawn = {};

  /// Draws the step; settings, display and range follow it.
  void draw(const Frame& frame) {
    settings.selection = ui::follow(settings.selection, frame);
    drawn = draw_next_step(frame, display, range, settings.scene, settings.view, settings.selection, settings.hidden);
  }
};

}  // namespace griffith::app
