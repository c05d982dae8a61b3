#include <map>
#include <utility>

#include "app/editor/editor.h"
#include "app/editor/editor_commands.h"
#include "app/editor/imgui_context_owner.h"
#include "app/output/open_world.h"
#include "app/render/painter.h"
#include "app/render/picture_maker.h"
#include "app/render/picture_text.h"
#include "renderer/target.h"

namespace griffith::app {
namespace {

constexpr int kFramesToLayOut = 3;  // the panels know their sizes only after being drawn

class EditorPainter : public Painter {
 public:
  EditorPainter(const RenderJob& job, const Scene& scene)
      : job_(job), editor_(scene, job.scene), imgui_(1), target_(job.width, job.height) {
    print_warnings(job.scene, world().findings());
    editor_.state().show_times = false;
    editor_.state().open_sections = job.open_sections;
    const ViewSettings own = editor_.state().view;
    for (const std::string& camera : job.cameras) {
      editor_.viewport().use_camera(scene, camera);
      for (const std::string& view : job.views) {
        editor_.state().view = own;
        editor_.viewport().use_view(view, world().frame());
        views_[{camera, view}] = editor_.state().view;
      }
    }
    if (job.cameras.size() > 1) editor_.viewport().use_camera(scene, job.cameras.front());
  }

  void step() override { editor_.run().step(); }
  const World& world() const override { return editor_.run().world(); }

  RenderedPicture paint(const std::string& camera, const std::string& view, double) override {
    if (job_.cameras.size() > 1) editor_.viewport().use_camera(editor_.document().scene(), camera);
    if (!painted_ || views_.size() > 1) editor_.state().view = views_.at({camera, view});
    painted_ = true;
    for (const std::string& command : std::exchange(job_.commands, {}))
      editor_.execute({.name = command_info(command).name});
    if (job_.node) editor_.state().selection = selected_node(job_, world().frame());
    RenderedPicture picture;
    picture.image = image();
    picture.record = world_record(world());
    picture.record.text = widget_text(editor_.tags());
    return picture;
  }

 private:
  render::Image image() {
    // Wait until everything that the commands began to build is ready.
    for (int quiet = 0; quiet < kFramesToLayOut; quiet = editor_.state().work.empty() ? quiet + 1 : 0) {
      editor_.draw_picture(job_.samples);
      imgui_.begin_frame(job_.width, job_.height);
      editor_.draw_panels(imgui_.fonts());
      target_.bind();
      target_.clear({});
      imgui_.end_frame();
    }
    return target_.image();
  }

  RenderJob job_;
  Editor editor_;
  ImGuiContextOwner imgui_;
  render::Target target_;
  std::map<std::pair<std::string, std::string>, ViewSettings> views_;  ///< by camera and view
  bool painted_ = false;
};

}  // namespace

std::unique_ptr<Painter> make_editor_painter(const RenderJob& job, const Scene& scene) {
  return std::make_unique<EditorPainter>(job, scene);
}

}  // namespace griffith::app
