#include "ui/number_slider.h"
#include "ui/panels.h"

namespace griffith::ui {

void draw_projectile_panel(Panel& panel) {
  heading(panel, "Projectile");
  ProjectileBurst& shot = panel.state.shot;
  number_slider(panel, {"projectile/speed", "Speed", "m/s", 0.1, 1000, true}, shot.speed);
  number_slider(panel, {"projectile/mass", "Mass", "kg", 1e-3, 1e5, true}, shot.mass);
  number_slider(panel, {"projectile/radius", "Radius", "m", 5e-3, 5, true}, shot.radius);
  integer_row(panel, "projectile/count", "Burst", shot.count, 1, 100);
  if (shot.count > 1) {
    number_slider(panel, {"projectile/interval", "Interval", "s", 1e-2, 5, true}, shot.interval);
  }
  hint(panel, "Right-click in the view, or press F, to fire at the cursor.");
}

}  // namespace griffith::ui
