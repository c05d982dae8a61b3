#include "ui/widgets/fonts.h"

#include <imgui.h>

#include <array>
#include <cmath>

// The font files are embedded in the program, so that it looks the same everywhere and needs no file at run time.
#define EMBED_FILE(symbol, path)                                                                 \
  __asm__(".pushsection .rodata\n.balign 16\n" #symbol "_begin:\n.incbin \"" path "\"\n" #symbol \
          "_end:\n.byte 0\n.popsection\n.global " #symbol "_begin\n.global " #symbol "_end\n");  \
  extern "C" const unsigned char symbol##_begin[], symbol##_end[];

EMBED_FILE(griffith_font_regular, GRIFFITH_FONT_REGULAR)
EMBED_FILE(griffith_font_bold, GRIFFITH_FONT_BOLD)

namespace griffith::ui {
namespace {

// Latin, Greek, superscripts, dashes and the few mathematical signs that labels use.
constexpr std::array<ImWchar, 15> kGlyphRanges = {0x20,   0xff,   0x370,  0x3ff,  0x2010, 0x2027, 0x2030, 0x205e,
                                                  0x2070, 0x2094, 0x2212, 0x221e, 0x2248, 0x2265, 0};

ImFont* add_font(const unsigned char* begin, const unsigned char* end, float pixels) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;  // the data is part of the program
  config.OversampleH = 2;
  return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(const_cast<unsigned char*>(begin), static_cast<int>(end - begin),
                                                    std::round(pixels), &config, kGlyphRanges.data());
}

}  // namespace

Fonts load_fonts(float scale) {
  Fonts fonts;
  fonts.regular = add_font(griffith_font_regular_begin, griffith_font_regular_end, 16 * scale);
  fonts.bold = add_font(griffith_font_bold_begin, griffith_font_bold_end, 16 * scale);
  fonts.small = add_font(griffith_font_regular_begin, griffith_font_regular_end, kSmallText * scale);
  return fonts;
}

}  // namespace griffith::ui
