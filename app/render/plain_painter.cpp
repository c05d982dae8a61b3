#include "app/output/open_world.h"
#include "app/render/painter.h"
#include "app/render/picture_maker.h"

namespace griffith::app {
namespace {

class PlainPainter : public Painter {
 public:
  PlainPainter(const RenderJob& job, const Scene& scene)
      : world_(open_world(scene, job.scene)), pictures_(job, scene, world_) {}

  void step() override {
    world_.step();
    pictures_.follow(world_);
  }

  const World& world() const override { return world_; }

  RenderedPicture paint(const std::string& camera, const std::string& view, double turn) override {
    return pictures_.paint(world_, camera, view, turn);
  }

 private:
  World world_;
  PictureMaker pictures_;
};

}  // namespace

std::unique_ptr<Painter> make_plain_painter(const RenderJob& job, const Scene& scene) {
  return std::make_unique<PlainPainter>(job, scene);
}

}  // namespace griffith::app
