#include "app/study/sweep_page.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/output/html_page.h"
#include "app/shared/processes.h"
#include "app/study/sweep_page_files.h"
#include "sim/core/read_file.h"

namespace griffith::app {
namespace {

namespace fs = std::filesystem;
using PageData = nlohmann::ordered_json;

constexpr std::string_view kBody = R"html(
<div id="plots">
<div class="controls">
  <label>Outcome <select id="outcome"></select></label>
  <label>Horizontal axis <select id="across"></select></label>
  <label>Color, vertical axis <select id="up"></select></label>
</div>
<div class="charts"><figure id="scatter"></figure><figure id="heat"></figure></div>
</div>
<div id="pictures"><h2>Pictures</h2><div class="sheet" id="sheet"></div></div>
<h2>All runs</h2>
<div class="scroll"><table id="table"></table></div>
<div id="bar" hidden><strong id="bar-title"></strong><span id="bar-copied" class="muted"></span><br>
<code id="bar-command"></code></div>
)html";

/// Returns a command that opens the run from any working folder.
std::string opening_command(const Sweep& sweep, std::size_t run) {
  RunRequest request = sweep.request(run);
  request.scene = fs::absolute(request.scene).lexically_normal();
  return shell_command(editor_words(request));
}

PageData finite(double value) { return std::isfinite(value) ? PageData(value) : PageData(); }

PageData parameters_data(const SweepPlan& plan) {
  PageData list = PageData::array();
  for (const Parameter& parameter : plan.parameters)
    list.push_back({{"name", parameter.name}, {"log", parameter.range && parameter.range->logarithmic}});
  return list;
}

PageData outcomes_data() {
  PageData list = PageData::array();
  for (const OutcomeKind& kind : outcome_kinds())
    if (kind.listing != OutcomeListing::other_name)
      list.push_back({{"key", kind.key},
                      {"unit", kind.unit},
                      {"meaning", kind.meaning},
                      {"main", kind.listing == OutcomeListing::main}});
  return list;
}

PageData run_data(const Sweep& sweep, std::size_t run, const RunRecord& record) {
  PageData data = {{"id", run + 1}, {"p", PageData::array()}, {"command", opening_command(sweep, run)}};
  for (const std::string& value : sweep.plan.runs[run]) {
    const PageData json = PageData::parse(value);
    data["p"].push_back(json.is_number() ? json : PageData(setting_word(value)));
  }
  if (record.error.empty()) {
    for (std::size_t i = 0; i < record.outcomes.size(); ++i)
      if (outcome_kinds()[i].listing != OutcomeListing::other_name) data["o"].push_back(finite(record.outcomes[i]));
  } else {
    data["error"] = record.error;
  }
  std::error_code error;
  if (sweep.picture_frame && fs::exists(sweep.picture_file(run), error))
    data["picture"] = png_data_uri(read_file(sweep.picture_file(run)));
  return data;
}

/// Returns JSON that may be embedded in an HTML element.
std::string embedded(const PageData& data) {
  std::string text;
  for (const char c : data.dump(-1, ' ', false, PageData::error_handler_t::replace))
    text += c == '<' ? std::string("\\u003c") : std::string(1, c);
  return "<script type=\"application/json\" id=\"data\">" + text + "</script>\n";
}

std::string introduction(const Sweep& sweep, std::size_t made, const std::string& note) {
  const std::string scene = escape_markup(sweep.definition.scene.filename().string());
  std::string text = "<h1>Sweep of " + scene + "</h1>\n<p class=\"muted\">" + std::to_string(made) + " of " +
                     std::to_string(sweep.size()) + " runs of " + std::to_string(sweep.definition.frames) +
                     " time steps. Click a run to see and copy the command that opens it.</p>\n";
  if (!note.empty()) text += "<p class=\"note\">" + escape_markup(note) + "</p>\n";
  return text;
}

}  // namespace

std::string sweep_page(const Sweep& sweep, const std::vector<std::optional<RunRecord>>& records,
                       const std::string& note) {
  PageData data = {
      {"parameters", parameters_data(sweep.plan)}, {"outcomes", outcomes_data()}, {"runs", PageData::array()}};
  for (std::size_t run = 0; run < records.size(); ++run)
    if (records[run]) data["runs"].push_back(run_data(sweep, run, *records[run]));
  std::string body = introduction(sweep, data["runs"].size(), note);
  body.append(kBody)
      .append(embedded(data))
      .append("<script>\n")
      .append(sweep_page_files::sweep_page_js)
      .append("</script>\n");
  const std::string style = std::string("<style>\n") + sweep_page_files::sweep_page_css + "</style>\n";
  return html_page("Sweep of " + sweep.definition.scene.filename().string(), style, body);
}

}  // namespace griffith::app
