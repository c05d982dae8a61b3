#pragma once

#include <string>

namespace griffith::ui {

/// Pictures that the dialog Render draws.
enum class RenderedSubject {
  still,      ///< one of the shown step
  turntable,  ///< several of the shown step, around the camera's target
  scenes,     ///< one of each scene in the folder of the open one
};

/// Input of the dialog Render, kept until the program ends.
struct RenderRequest {
  bool shown = false;
  RenderedSubject subject = RenderedSubject::still;
  int width = 1920, height = 1080;  ///< [pixels]
  bool poster = false;              ///< with depth of field and motion blur, else in the quality of the view
  int pictures = 90;                ///< number of pictures of a turntable
  int step = 60;                    ///< time steps before the pictures of scenes
  std::string path;  ///< file, or folder for pictures of scenes; relative to the folder of the open scene
};

}  // namespace griffith::ui
