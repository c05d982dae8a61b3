#include "sim/core/file_content.h"

#include <gmock/gmock.h>

#include "sim/core/error.h"
#include "test_folder.h"
#include "tests/input_error_of.h"

namespace griffith {
namespace {

using ::testing::HasSubstr;
using namespace griffith::testing;

std::string error_of(const std::string& name, std::string_view content) {
  return input_error_of([&] { require_expected_content(name, content); });
}

constexpr char kPointer[] = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";

TEST(FileContent, PointersOfGitLfsAreReportedEveryKindOfFile) {
  for (const char* name : {"a.obj", "a.msh", "a.vtk", "a.json", "a.tar.zst", "a.png", "a.STL", "verts.csv", "a"})
    EXPECT_THAT(error_of(name, kPointer), HasSubstr("is a pointer of Git LFS, not the file itself (install git-lfs"))
        << name;
}

TEST(FileContent, AnotherFormatIsNamedWithItsEnding) {
  EXPECT_THAT(error_of("a.vtk", "<?xml version=\"1.0\"?>\n<VTKFile>"),
              HasSubstr("a.vtk: is XML (end its name in .vtu"));
  EXPECT_THAT(error_of("a.vtk", " <VTKFile type=\"UnstructuredGrid\">"), HasSubstr("is a VTK file in XML"));
  EXPECT_THAT(error_of("a.vtu", "# vtk DataFile Version 3.0\n"), HasSubstr("end its name in .vtk"));
  EXPECT_THAT(error_of("a.mesh", "$MeshFormat\n4.1 0 8\n"), HasSubstr("end its name in .msh"));
  EXPECT_THAT(error_of("a.msh", " MeshVersionFormatted 2\n"), HasSubstr("end its name in .mesh"));
  EXPECT_THAT(error_of("a.obj", "solid cube\n"), HasSubstr("end its name in .stl"));
  EXPECT_THAT(error_of("a.stl", "\xef\xbb\xbf<!DOCTYPE HTML>\n"), HasSubstr("is a web page"));
  EXPECT_THAT(error_of("a.obj", "\x1f\x8b\x08"), HasSubstr("is compressed by gzip (unpack it"));
}

TEST(FileContent, Version1OfMshIsNamedWithWhatConvertsIt) {
  for (const char* content : {"$NOD\n4\n", "$NOD\r\n4\r\n"})
    EXPECT_THAT(error_of("a.msh", content), HasSubstr("version 1 of MSH (convert it to version 4.1: gmsh OLD.msh -save "
                                                      "-format msh41 -o NEW.msh)"));
}

TEST(FileContent, WhatAFileMayHoldPasses) {
  EXPECT_EQ(error_of("a.vtu", "<?xml version=\"1.0\"?>\n<VTKFile>"), "no error");
  EXPECT_EQ(error_of("a.vtk", "# vtk DataFile Version 3.0\n"), "no error");
  EXPECT_EQ(error_of("a.MSH", "$MeshFormat\n"), "no error");
  EXPECT_EQ(error_of("a.mesh", " MeshVersionFormatted 2\n"), "no error");
  EXPECT_EQ(error_of("a.stl", "solid cube\n"), "no error");
  EXPECT_EQ(error_of("a.tar.zst", "\x28\xb5\x2f\xfd"), "no error");
  EXPECT_EQ(error_of("a.json", "{}"), "no error");
  EXPECT_EQ(error_of("a.obj", ""), "no error");
}

TEST(FileContent, TheBeginningOfAFileIsLookedAtOnDisk) {
  const auto folder = empty_folder();
  EXPECT_THROW(require_expected_content(written(folder / "a.obj", kPointer)), InputError);
  EXPECT_THROW(read_expected_file(written(folder / "b.obj", kPointer)), InputError);
  EXPECT_NO_THROW(require_expected_content(written(folder / "c.obj", "v 0 0 0\n")));
  EXPECT_NO_THROW(require_expected_content(folder / "none.obj"));
  EXPECT_EQ(read_expected_file(written(folder / "d.json", "{}")), "{}");
}

}  // namespace
}  // namespace griffith
