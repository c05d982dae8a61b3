#include "app/export/export_bake.h"

#include <string_view>

#include "app/export/bake_json.h"
#include "app/export/bond_csv.h"
#include "app/export/glb_file.h"
#include "app/export/html_player.h"
#include "app/export/usda_file.h"
#include "sim/core/error.h"
#include "sim/core/replace_file.h"

namespace griffith::app {
namespace {

struct BakeFormat {
  std::string_view suffix;
  std::string (*text)(const Bake&);
};

constexpr BakeFormat kBakeFormats[] = {
    {".glb", glb_file}, {".usda", usda_file}, {".json", bake_json}, {".csv", bond_csv}, {".html", html_player}};

const BakeFormat& format_of(const std::filesystem::path& path) {
  for (const BakeFormat& format : kBakeFormats)
    if (path.extension() == format.suffix) return format;
  throw InputError(path.string(), "has no supported extension", "use .glb, .usda, .html, .json or .csv");
}

}  // namespace

void check_bake_path(const std::filesystem::path& path) { format_of(path); }

std::size_t export_bake(const std::filesystem::path& path, const Bake& bake) {
  const std::string content = format_of(path).text(bake);
  replace_file(path, content);
  return content.size();
}

}  // namespace griffith::app
