#include "gpu/gl_objects.h"

#include <catch2/catch.hpp>

#include "support/gl_test_context.h"
#include "gpu/gpu_scene.h"
#include "gpu/program.h"
#include "support/village.h"

using namespace dimline;

TEST_CASE("a GL object goes with its owner, and moves with it") {
  const test::GlTestContext context;
  GLuint id = 0;
  {
    Texture first = makeTexture2D(*context.gl, GL_R8, 4, 4, Sampling::kNearest);
    id = first.id();
    Texture second = std::move(first);
    CHECK_FALSE(first);
    CHECK(second.id() == id);
    CHECK(glIsTexture(id) == GL_TRUE);
  }
  CHECK(glIsTexture(id) == GL_FALSE);
}

TEST_CASE("after its context is lost an object makes no GL call") {
  const test::GlTestContext context;
  GLuint id = 0;
  {
    const Texture texture = makeTexture2D(*context.gl, GL_R8, 4, 4, Sampling::kNearest);
    id = texture.id();
    context.gl->markLost();
  }
  CHECK(glIsTexture(id) == GL_TRUE);
}

TEST_CASE("a shader that does not compile says which one and why") {
  const test::GlTestContext context;
  Program program(*context.gl, {.label = "nonsense",
                                .vertex = {"void main() { gl_Position = vec4(0.0); }\n"},
                                .fragment = {"out vec4 c;\nvoid main() { c = nothing; }\n"}});
  const Status status = program.status();
  REQUIRE_FALSE(status);
  CHECK(status.error().message.find("fragment shader of \"nonsense\"") != std::string::npos);
  CHECK(status.error().message.find("nothing") != std::string::npos);
  CHECK(status.error().message.find("2") != std::string::npos);   // the line
}

TEST_CASE("shaders that do not fit together say so") {
  const test::GlTestContext context;
  Program program(*context.gl, {.label = "misfits",
                                .vertex = {"out float a;\nvoid main() { a = 1.0; gl_Position = vec4(0.0); }\n"},
                                .fragment = {"in vec3 a;\nout vec4 c;\nvoid main() { c = vec4(a, 1.0); }\n"}});
  const Status status = program.status();
  REQUIRE_FALSE(status);
  CHECK(status.error().message.find("\"misfits\" do not link") != std::string::npos);
}

TEST_CASE("a framebuffer that cannot be drawn to is an error with its name") {
  const test::GlTestContext context;
  const Texture texture = makeTexture2D(*context.gl, GL_RGB9_E5, 4, 4, Sampling::kNearest);
  const Result<Framebuffer> framebuffer = makeFramebuffer(*context.gl, "shiny", texture.id(), 0);
  REQUIRE_FALSE(framebuffer);
  CHECK(framebuffer.error().message.find("shiny") != std::string::npos);
}

TEST_CASE("a scene's triangles are grouped by what shader they want, and can be replaced") {
  const test::GlTestContext context;
  GpuScene gpuScene(*context.gl);
  CHECK(gpuScene.empty());
  const Scene scene = test::villageScene();
  for (int round = 0; round < 3; ++round) {
    gpuScene.upload(scene);
    CHECK(gpuScene.groups().size() == 5);
    CHECK(glGetError() == GL_NO_ERROR);
  }
  gpuScene.upload(Scene{});
  CHECK(gpuScene.empty());
  gpuScene.drawPositions();
  CHECK(glGetError() == GL_NO_ERROR);
}

TEST_CASE("images that the driver cannot hold, or that have no pixels, are no error") {
  const test::GlTestContext context;
  GpuScene gpuScene(*context.gl);
  Scene scene = test::villageScene();
  const auto wide = static_cast<std::uint32_t>(context.gl->maxTextureSize()) + 1;
  scene.images.push_back(share({wide, 2, std::vector<std::uint8_t>(std::size_t{wide} * 2 * 4, 128)}));
  scene.images.push_back(share({}));
  scene.images.push_back(share({4, 4, {1, 2, 3}}));
  gpuScene.upload(scene);
  CHECK(glGetError() == GL_NO_ERROR);
  for (int i = 0; i < 3; ++i) CHECK(glIsTexture(gpuScene.imageTexture(i)) == GL_TRUE);
}
