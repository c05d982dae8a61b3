#include <algorithm>

#include "app/output/html_page.h"
#include "app/output/id_picture.h"
#include "app/regress/report.h"

namespace griffith::app {
namespace {

/// Returns an image with its caption. `kind`: the image's class.
std::string figure(const std::string& png, const std::string& kind, const std::string& caption) {
  if (png.empty()) return "";
  return "<figure><img class=\"" + kind + "\" src=\"" + png_data_uri(png) + "\" alt=\"" + caption +
         "\" decoding=\"async\"><figcaption>" + caption + "</figcaption></figure>\n";
}

std::string badge(const std::string& color, const std::string& text) {
  return "<span class=\"badge " + color + "\">" + text + "</span>\n";
}

std::string status_badge(PictureStatus status) {
  switch (status) {
    case PictureStatus::passed:
      return badge("good", "passed");
    case PictureStatus::failed:
      return badge("bad", "failed");
    case PictureStatus::missing_golden:
      return badge("warn", "no golden picture");
    case PictureStatus::error:
      return badge("bad", "error");
  }
  return "";
}

std::string cause_badge(const PictureResult& result) {
  if (!result.simulation_changed || result.status != PictureStatus::failed) return "";
  return *result.simulation_changed ? badge("warn", "the simulation changed")
                                    : badge("muted", "only the drawing changed");
}

std::string article_header(const PictureResult& result, const std::string& anchor) {
  return "<header><h2><a href=\"#" + anchor + "\">" + escape_markup(result.name) + "</a></h2>\n" +
         status_badge(result.status) + cause_badge(result) + "</header>\n";
}

/// Returns golden, actual and difference side by side.
std::string sides(const PictureResult& result) {
  const std::string figures = figure(result.golden, "golden", "golden") + figure(result.actual, "new", "new") +
                              figure(result.difference, "difference", "difference");
  if (figures.empty()) return "";
  const char* key =
      "<p class=\"key muted\"><i class=\"off\"></i>off <i class=\"brighter\"></i>a little brighter "
      "<i class=\"darker\"></i>a little darker</p>\n";
  return "<div class=\"sides\">\n" + figures + "</div>\n" + (result.difference.empty() ? "" : key);
}

std::string rule_row(const ToleranceRule& rule) {
  return std::string(rule.is_kept() ? "<tr>" : "<tr class=\"broken\">") + "<td>" + rule.name +
         "</td><td class=\"number\">" + rule_text(rule, rule.found) + "</td><td class=\"number\">" +
         rule_text(rule, rule.allowed) + "</td></tr>\n";
}

/// Returns a table of all rules with measured and allowed values.
std::string rule_table(const PictureResult& result) {
  std::string table =
      "<table><thead><tr><th>Compared</th><th class=\"number\">found</th><th class=\"number\">allowed</th></tr></thead>"
      "<tbody>\n";
  for (const ToleranceRule& rule : result.image.rules) table += rule_row(rule);
  for (const ToleranceRule& rule : result.ids.rules) table += rule_row(rule);
  return table + "<tr><td>largest difference of a pixel</td><td class=\"number\">" +
         std::to_string(result.image.largest_difference) +
         " of 255</td><td class=\"number\">any</td></tr>\n</tbody></table>\n";
}

std::string worst_tile(const PictureResult& result) {
  const PixelRect& tile = result.image.off.count > 0 ? result.image.off.worst_tile : result.image.drift_tile;
  return "<h3>Around the worst tile, at (" + std::to_string(tile.left) + ", " + std::to_string(tile.top) +
         ")</h3>\n<div class=\"tiles\">" + figure(result.golden_tile, "tile", "golden") +
         figure(result.actual_tile, "tile", "new") + figure(result.difference_tile, "tile", "difference") + "</div>\n";
}

/// Returns the overlay of both pictures, filled in by the script, the worst tile and the rules.
std::string closer_look(const PictureResult& result) {
  if (result.difference_tile.empty()) return "";
  constexpr char kStage[] =
      "<div class=\"over\" hidden><h3>Overlay</h3>\n"
      "<div class=\"stage\"><img class=\"golden\" alt=\"golden\"><img class=\"new\" alt=\"new\"><div "
      "class=\"line\"></div>"
      "<span class=\"side left\">golden</span><span class=\"side right\">new</span></div>\n"
      "<div class=\"controls\"><button class=\"blink\" aria-pressed=\"false\">Blink</button>"
      "<input class=\"slider\" type=\"range\" value=\"50\" step=\"0.5\" aria-label=\"where the new picture "
      "begins\"></div>"
      "</div>\n";
  return std::string("<div class=\"closer\">\n") + kStage + "<div>" + worst_tile(result) + rule_table(result) +
         "</div>\n</div>\n";
}

std::string cell(const std::optional<std::string>& value, const std::string& attributes) {
  return "<td" + attributes + ">" + (value ? escape_markup(*value) : "<span class=\"muted\">none</span>") + "</td>";
}

/// Returns a row with both values if they differ, else with their common one.
std::string value_row(const PictureResult::Row& row, bool has_golden, const std::string& kind) {
  const std::string name = "<td>" + escape_markup(row.name) + "</td>";
  if (!has_golden) return "<tr>" + name + cell(row.actual, kind) + "</tr>\n";
  if (row.golden == row.actual) return "<tr>" + name + cell(row.actual, kind + " colspan=\"2\"") + "</tr>\n";
  return "<tr class=\"differs\">" + name + cell(row.golden, kind) + cell(row.actual, kind) + "</tr>\n";
}

std::string value_table(const std::string& title, const std::vector<PictureResult::Row>& rows, bool has_golden,
                        bool numbers) {
  if (rows.empty()) return "";
  const std::string kind = numbers ? " class=\"number\"" : "";
  std::string table = "<table><thead><tr><th>" + title + "</th>";
  if (has_golden) table += "<th" + kind + ">golden</th>";
  table += "<th" + kind + ">new</th></tr></thead><tbody>\n";
  for (const PictureResult::Row& row : rows) table += value_row(row, has_golden, kind);
  return table + "</tbody></table>\n";
}

std::string value_tables(const PictureResult& result) {
  const bool has_golden = result.status == PictureStatus::failed;
  const std::string scene = result.scene ? value_table("Scene", *result.scene, has_golden, false) : std::string();
  const std::string tables = scene + value_table("Metadata", result.metadata, has_golden, false) +
                             value_table("Statistics", result.statistics, has_golden, true);
  return tables.empty() ? "" : "<div class=\"tables\">\n" + tables + "</div>\n";
}

std::string diff_line(const DiffLine& line) {
  switch (line.kind) {
    case DiffLine::Kind::same:
      return "  " + escape_markup(line.text) + "\n";
    case DiffLine::Kind::removed:
      return "<span class=\"removed\">- " + escape_markup(line.text) + "</span>\n";
    case DiffLine::Kind::added:
      return "<span class=\"added\">+ " + escape_markup(line.text) + "</span>\n";
    case DiffLine::Kind::skipped:
      return "<span class=\"muted\">  …</span>\n";
  }
  return "";
}

std::string text_changes(const PictureResult& result) {
  if (result.text.empty()) return "";
  std::string lines = "<h3>Text</h3>\n<pre class=\"diff\">";
  for (const DiffLine& line : result.text) lines += diff_line(line);
  return lines + "</pre>\n";
}

std::string id_pictures(const PictureResult& result) {
  if (result.golden_ids.empty()) return "";
  return "<details><summary>Ids of drawn objects: " + escape_markup(result.ids.reason) +
         "</summary>\n<div class=\"ids\">" + figure(result.golden_ids, "ids", "golden") +
         figure(result.actual_ids, "ids", "new") + "</div></details>\n";
}

}  // namespace

std::string command_html(const std::string& command) {
  if (command.empty()) return "";
  return "<div class=\"command\"><span class=\"muted\">Accept:</span><code>" + escape_markup(command) +
         "</code><button>Copy</button></div>\n";
}

std::string report_article(const PictureResult& result, int number) {
  const std::string anchor = "picture-" + std::to_string(number), status = status_name(result.status);
  return "<article class=\"picture " + status + "\" id=\"" + anchor + "\" data-status=\"" + status + "\" data-name=\"" +
         escape_markup(result.name) + "\">\n" + article_header(result, anchor) + "<p class=\"reason\">" +
         escape_markup(result.reason) + "</p>\n" + sides(result) + closer_look(result) + value_tables(result) +
         text_changes(result) + id_pictures(result) + command_html(result.accept_command) + "</article>\n";
}

}  // namespace griffith::app
