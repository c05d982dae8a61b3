#include "app/editor/editor.h"
#include "app/editor/run_export.h"
#include "sim/core/monitor.h"

namespace griffith::app {

void Editor::export_run(const std::filesystem::path& path) {
  state_.running = false;
  const PictureKey key = picture_key();
  export_ =
      start_export(path, timeline_, display_, {picture_camera(), state_.view, hidden_bodies(), key.width, key.height});
  state_.work = export_->stage();
}

void Editor::go_on_with_export() {
  if (!export_) return;
  try {
    if (std::exchange(state_.cancel_work, false)) {
      const std::string written = export_->cancel();
      log(ui::LogLevel::warning,
          "The export was cancelled: " + (written.empty() ? "nothing was written." : "wrote " + written + " before."));
      export_.reset();
    } else if (const std::optional<std::string> written = export_->advance()) {
      log(ui::LogLevel::info, "Wrote " + *written);
      export_.reset();
    }
  } catch (const InputError& error) {
    export_.reset();
    show_error(error);
  } catch (const std::exception& error) {
    export_.reset();
    show_error(InputError("the export", std::string("failed: ") + error.what(), ""));
  }
}

}  // namespace griffith::app
