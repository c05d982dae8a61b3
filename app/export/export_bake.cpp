#include "app/export/export_bake.h"

#include <string_view>

#include "app/export/bake_json.h"
#include "app/export/bond_csv.h"
#include "app/export/glb_file.h"
#include "app/export/html_player.h"
#include "app/export/usda_file.h"
#include "app/output/file_formats.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

struct BakeFormat {
  std::string_view extension;
  std::string_view content;
  std::string_view purpose;   ///< heading in the editor's dialog
  std::string_view programs;  ///< programs that read it; may be empty
  std::string (*text)(const Bake&);
};

constexpr char kPieces[] = "Pieces, motion and bonds", kPage[] = "Page for a browser";

constexpr BakeFormat kBakeFormats[] = {{".glb", "glTF", kPieces, "Blender, Unity, Unreal", glb_file},
                                       {".usda", "USD", kPieces, "USD", usda_file},
                                       {".html", "a page that plays the run", kPage, "", html_player},
                                       {".json", "pieces and bonds", kPieces, "", bake_json},
                                       {".csv", "bonds", kPieces, "", bond_csv}};

}  // namespace

void check_bake_path(const std::filesystem::path& path) { format_of(kBakeFormats, path); }

std::string bake_formats_text() { return formats_text(kBakeFormats); }

std::vector<std::string> bake_hints() {
  std::vector<std::string> lines;
  for (const char* purpose : {kPieces, kPage}) {
    std::string line = purpose;
    for (const BakeFormat& format : kBakeFormats) {
      if (format.purpose != purpose) continue;
      line.append(line == purpose ? ": " : ", ").append(format.extension);
      if (!format.programs.empty()) line.append(" (").append(format.programs).append(")");
    }
    lines.push_back(line);
  }
  return lines;
}

std::size_t export_bake(const std::filesystem::path& path, const Bake& bake) {
  const std::string content = format_of(kBakeFormats, path).text(bake);
  replace_file(path, content);
  return content.size();
}

}  // namespace griffith::app
