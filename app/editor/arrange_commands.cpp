#include "app/editor/arrange.h"
#include "app/editor/editor.h"
#include "app/editor/editor_commands.h"
#include "app/editor/messages.h"
#include "ui/model/entry_choice.h"

namespace griffith::app {
using ui::CommandArgument;
using ui::CommandContext;
using ui::Menu;

namespace {

std::size_t chosen_bodies(const CommandContext& context) {
  return ui::selected_body_indices(context.state, context.history.scene()).size();
}

std::string_view no_chosen_body(const CommandContext& context) {
  return unless(chosen_bodies(context) > 0, "No body is selected in the outliner.");
}

std::string_view fewer_than_two_bodies(const CommandContext& context) {
  return unless(chosen_bodies(context) > 1, "Select the bodies to align in the outliner, the one to align with last.");
}

void mirror(Editor& e, int axis) { mirror_bodies(e.document().history(), e.state(), axis); }
void align(Editor& e, int axis) { align_bodies(e.document().history(), e.state(), axis); }

const EditorCommand kArrangeCommands[] = {
    {{.name = "edit.drop",
      .label = "Drop",
      .hint = "Move the selected bodies straight down until each rests on the ground or on a body",
      .menu = Menu::edit,
      .group = 2,
      .shortcut = {ui::key::kEnd},
      .disabled_reason = no_chosen_body},
     [](Editor& e, const ui::Command&) {
       if (drop_bodies(e.document().history(), e.state())) return;
       log_message(e.state(), ui::LogLevel::info, "Nothing to drop: what is selected rests already.",
                   ui::LogSpan::action);
     }},
    {{.name = "edit.array",
      .label = "Array…",
      .hint = "Repeat the selected bodies at equal distances",
      .menu = Menu::edit,
      .group = 2,
      .shortcut = {'D', true, true},
      .disabled_reason = no_chosen_body,
      .argument = CommandArgument::array,
      .with_path = "edit.make_array"},
     [](Editor& e, const ui::Command&) {
       e.state().array = ui::ArrayRequest{2, side_by_side(e.document().scene(), e.state())};
     }},
    {{.name = "edit.mirror_x",
      .label = "Mirror left to right",
      .hint = "Add mirror images along x, about the center of the body selected last, or of the origin for one body",
      .menu = Menu::edit,
      .group = 2,
      .disabled_reason = no_chosen_body},
     [](Editor& e, const ui::Command&) { mirror(e, 0); }},
    {{.name = "edit.mirror_z",
      .label = "Mirror front to back",
      .hint = "Add mirror images along z, about the center of the body selected last, or of the origin for one body",
      .menu = Menu::edit,
      .group = 2,
      .disabled_reason = no_chosen_body},
     [](Editor& e, const ui::Command&) { mirror(e, 2); }},
    {{.name = "edit.align_x",
      .label = "Align along x",
      .hint = "Move the selected bodies along x until their centers are level with that of the last one",
      .menu = Menu::edit,
      .group = 2,
      .disabled_reason = fewer_than_two_bodies},
     [](Editor& e, const ui::Command&) { align(e, 0); }},
    {{.name = "edit.align_y",
      .label = "Align along y",
      .hint = "Move the selected bodies along y until their centers are level with that of the last one",
      .menu = Menu::edit,
      .group = 2,
      .disabled_reason = fewer_than_two_bodies},
     [](Editor& e, const ui::Command&) { align(e, 1); }},
    {{.name = "edit.align_z",
      .label = "Align along z",
      .hint = "Move the selected bodies along z until their centers are level with that of the last one",
      .menu = Menu::edit,
      .group = 2,
      .disabled_reason = fewer_than_two_bodies},
     [](Editor& e, const ui::Command&) { align(e, 2); }},
    {{.name = "edit.make_array",
      .label = "Repeat bodies",
      .hint = "Repeat the selected bodies so that there are a number of each, at that offset",
      .disabled_reason = no_chosen_body,
      .argument = CommandArgument::array},
     [](Editor& e, const ui::Command& c) {
       array_bodies(e.document().history(), e.state(), static_cast<int>(c.step), c.offset);
     }},
};

}  // namespace

std::span<const EditorCommand> arrange_commands() { return kArrangeCommands; }

}  // namespace griffith::app
