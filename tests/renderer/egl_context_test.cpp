#include "renderer/egl_context.h"

#include <epoxy/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "renderer/error.h"

namespace griffith::render {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(EglContext, SaysWhatItIs) {
  const EglContext context;
  EXPECT_FALSE(context.renderer().empty());
  EXPECT_FALSE(context.origin().empty());
  GLint major = 0, minor = 0;
  glGetIntegerv(GL_MAJOR_VERSION, &major);
  glGetIntegerv(GL_MINOR_VERSION, &minor);
  EXPECT_GE(10 * major + minor, 33) << context.version();
}

TEST(EglContext, AMissingDeviceIsAnErrorThatListsWhatWasTriedAndWhatThereIs) {
  try {
    const EglContext context(99);
    FAIL() << "made " << context.origin();
  } catch (const RenderError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("Tried:\n  device 99: there is no such device"), HasSubstr("Available: ")));
  }
}

TEST(EglContext, MovesAndSwitchesBetweenContexts) {
  EglContext first;
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  {
    const EglContext second;
    EXPECT_FALSE(glIsTexture(texture));
  }
  const EglContext moved = std::move(first);
  moved.make_current();
  EXPECT_TRUE(glIsTexture(texture));
}

}  // namespace
}  // namespace griffith::render
