#include "app/regress/report.h"

#include <algorithm>
#include <array>
#include <cstdio>

#include "app/output/html_page.h"
#include "app/regress/report_files.h"

namespace griffith::app {
namespace {

int count_of(std::span<const PictureResult> results, PictureStatus status) {
  return static_cast<int>(std::ranges::count(results, status, &PictureResult::status));
}

std::string count_html(int count, const std::string& color, const std::string& what) {
  return "<span" + (count > 0 ? " class=\"" + color + "\"" : " class=\"muted\"") + "><b>" + std::to_string(count) +
         "</b>" + what + "</span>\n";
}

std::string heading_html(const ReportHeading& heading, std::span<const PictureResult> results) {
  char seconds[32];
  std::snprintf(seconds, sizeof seconds, "%.1f s", heading.seconds);
  const int passed = count_of(results, PictureStatus::passed);
  const bool all = passed == static_cast<int>(results.size());
  return "<h1>" + escape_markup(heading.suite) + "</h1>\n<div class=\"counts\">\n" +
         count_html(count_of(results, PictureStatus::failed), "bad", "failed") +
         count_html(count_of(results, PictureStatus::error), "bad", "not drawn") +
         count_html(count_of(results, PictureStatus::missing_golden), "warn", "without golden picture") +
         count_html(passed, "good", "passed") + "</div>\n<div class=\"muted\">" + escape_markup(heading.version) +
         " · " + escape_markup(heading.renderer) + " · " + seconds + "</div>\n" +
         (all ? "" : command_html(heading.accept_command));
}

std::string filter_html(std::span<const PictureResult> results) {
  std::string html = "<div class=\"filter\"><button data-shows=\"all\" aria-pressed=\"true\">All</button>\n";
  for (const PictureStatus status :
       {PictureStatus::failed, PictureStatus::error, PictureStatus::missing_golden, PictureStatus::passed}) {
    if (count_of(results, status) == 0) continue;
    static constexpr std::array kLabels = {"Passed", "Failed", "Without golden picture", "Not drawn"};
    html += std::string("<button data-shows=\"") + status_name(status) + "\" aria-pressed=\"false\">" +
            kLabels[static_cast<std::size_t>(status)] + "</button>\n";
  }
  return html + "<input type=\"search\" placeholder=\"Search names\" aria-label=\"Search names\"></div>\n";
}

/// Describes the remaining difference of a picture that passed.
std::string nearness(const ImageComparison& comparison) {
  if (comparison.equal) return "equal";
  return std::to_string(comparison.off.count) + (comparison.off.count == 1 ? " pixel off" : " pixels off");
}

std::string thumbnail_html(const PictureResult& result) {
  return "<figure data-status=\"passed\" data-name=\"" + escape_markup(result.name) + "\"><img loading=\"lazy\" " +
         "decoding=\"async\" alt=\"\" src=\"" + png_data_uri(result.thumbnail) + "\"><figcaption>" +
         escape_markup(result.name) + " · " + nearness(result.image) + "</figcaption></figure>\n";
}

/// Returns the thumbnails, folded if other pictures need attention.
std::string passed_html(std::span<const PictureResult> results) {
  const int passed = count_of(results, PictureStatus::passed);
  if (passed == 0) return "";
  const bool all = passed == static_cast<int>(results.size());
  std::string html = std::string("<details class=\"passed\"") + (all ? " open" : "") + "><summary>" +
                     std::to_string(passed) + " passed</summary>\n<div class=\"thumbnails\">\n";
  for (const PictureResult& result : results)
    if (result.status == PictureStatus::passed) html += thumbnail_html(result);
  return html + "</div></details>\n";
}

std::string articles(std::span<const PictureResult> results) {
  std::string html;
  int number = 0;
  for (const PictureStatus status : {PictureStatus::failed, PictureStatus::error, PictureStatus::missing_golden})
    for (const PictureResult& result : results)
      if (result.status == status) html += report_article(result, ++number);
  return html;
}

}  // namespace

std::string report_html(const ReportHeading& heading, std::span<const PictureResult> results) {
  const int others = static_cast<int>(results.size()) - count_of(results, PictureStatus::passed);
  const std::string title = (others > 0 ? std::to_string(others) + " failed: " : "Passed: ") + heading.suite;
  return html_page(title, std::string("<style>\n") + report_files::report_css + "</style>\n",
                   heading_html(heading, results) + filter_html(results) + articles(results) + passed_html(results) +
                       "<script>\n" + report_files::report_js + "</script>\n");
}

}  // namespace griffith::app
