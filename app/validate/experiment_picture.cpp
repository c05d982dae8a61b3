#include "app/validate/experiment_picture.h"

#include "app/render/picture_maker.h"

namespace griffith::app {

render::Image experiment_picture(const Experiment& experiment) {
  const World world = experiment.pictured();
  RenderJob job;
  job.name = experiment.key;
  job.width = 960;
  job.height = 540;
  return PictureMaker(job, world.scene(), world).paint(world, "", "").image;
}

}  // namespace griffith::app
