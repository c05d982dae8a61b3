#include <cstdio>
#include <exception>
#include <string_view>

#include "tests/validation/validation_case.h"

namespace {

using namespace griffith::validation;

int print_row(const Row& row) {
  constexpr const char* kSigns[] = {"", "≤ ", "≥ "};
  std::printf("| %s | %s | %s | %s%.4g | %.4g | ", row.mesh.pattern.c_str(), row.mesh.resolution.c_str(),
              row.quantity.c_str(), kSigns[static_cast<int>(row.check)], row.expected, row.got);
  if (row.check == Check::near)
    std::printf("%+.2g | %.2g", row.error(), row.tolerance);
  else
    std::printf("| ");
  std::printf(" | %s |\n", row.passes() ? "yes" : "**no**");
  return row.passes() ? 0 : 1;
}

/// Returns how many figures are outside.
int print_case(const Case& known, Extent extent) {
  std::printf("\n## %s\n\n%s\n\n", known.title, known.about);
  std::printf("| pattern | resolution | quantity | expected | got | error | tolerance | pass |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  int outside = 0;
  for (const Row& row : known.run(extent)) outside += print_row(row);
  std::fflush(stdout);
  return outside;
}

}  // namespace

/// Prints every case as Markdown, or the one named; --quick leaves out the finest meshes. Exits with 1 if a figure is
/// outside its tolerance.
int main(int argc, char** argv) try {
  Extent extent = Extent::table;
  std::string_view wanted;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) == "--quick")
      extent = Extent::test;
    else
      wanted = argv[i];
  }
  int outside = 0;
  for (const Case& known : cases())
    if (wanted.empty() || wanted == known.name) outside += print_case(known, extent);
  if (outside > 0) std::fprintf(stderr, "%d figures are outside their tolerances\n", outside);
  return outside > 0 ? 1 : 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
