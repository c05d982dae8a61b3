#include "app/editor/editor.h"
#include "app/editor/editor_commands.h"

namespace griffith::app {
using ui::CommandArgument;
using ui::CommandContext;
using ui::Menu;

namespace {

const EditorCommand kMacroCommands[] = {
    {{.name = "edit.record_macro",
      .label = "Record macro",
      .hint = "Record your actions as a script until you choose this again; macros are in this menu and in the palette",
      .menu = Menu::edit,
      .group = 3,
      .is_on = [](const CommandContext& context) { return context.state.recording_macro; },
      .recorded = false},
     [](Editor& e, const ui::Command&) { e.scripting().toggle_recording(); }},
    {{.name = "edit.save_macro",
      .label = "Save macro…",
      .hint = "Save the last recorded macro",
      .argument = CommandArgument::path,
      .with_path = "edit.write_macro"},
     [](Editor& e, const ui::Command& c) { e.scripting().ask_where_to_save(c.path); }},
    {{.name = "edit.write_macro",
      .label = "Write macro",
      .hint = "Write the last recorded macro to a file",
      .argument = CommandArgument::path,
      .recorded = false,
      .for_pictures = false},
     [](Editor& e, const ui::Command& c) { e.scripting().save(c); }},
    {{.name = "edit.play_macro",
      .label = "Play macro",
      .hint = "Play the script with the given path",
      .argument = CommandArgument::path,
      .recorded = false,
      .for_pictures = false},
     [](Editor& e, const ui::Command& c) { e.scripting().play(read_script(c.path)); }},
};

}  // namespace

std::span<const EditorCommand> macro_commands() { return kMacroCommands; }

}  // namespace griffith::app
