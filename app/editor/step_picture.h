#pragma once

#include "app/picture/draw_scene_from_frame.h"
#include "sim/core/copy_on_write.h"

namespace griffith::app {

/// Settings of a picture; equal settings give equal pictures of a frame.
struct PictureSettings {
  Scene scene;  ///< scene from which the world was built, with its current materials
  ViewSettings view;
  ui::Selection selection;
  HiddenBodies hidden;
  bool operator==(const PictureSettings&) const = default;
};

/// A picture of the next step, to be made on any thread: a value that contains everything but that step.
struct StepPicture {
  PictureSettings settings;
  CopyOnWrite<EmbeddedDisplay> display;  ///< state after the previous steps
  SteadyRange range;                     ///< state after the previous steps
  render::DrawScene drawn = {};

  /// Draws the step and updates settings, display and range.
  void draw(const Frame& frame) {
    settings.selection = ui::follow(settings.selection, frame);
    drawn = draw_next_step(frame, display, range, settings.scene, settings.view, settings.selection, settings.hidden);
  }
};

}  // namespace griffith::app
