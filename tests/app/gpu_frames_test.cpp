#include <catch2/catch.hpp>

#include "app/editor_stage.h"
#include "models/models.h"
#include "support/gl_test_context.h"

// Software GL drivers keep memory to the end of the process, which the address sanitizer takes for leaks of ours.
#ifndef __SANITIZE_ADDRESS__

using namespace dimline;
using namespace dimline::test;

TEST_CASE("frames that the GPU measures and draws allocate nothing once the flight has been flown") {
  const GlTestContext context;
  EditorStage stage(defineLever(), 200, 150);
  stage.editor.attachRenderer();
  REQUIRE(stage.editor.problem().empty());
  stage.editor.setFieldsFrom(Editor::FieldsFrom::kGpu);
  const Bounds& bounds = stage.editor.scene().bounds;
  const auto fly = [&] { return allocatedInFlight(stage, 60, 1, [&](int i) { return orbitCamera(bounds.center(), 1.8 * bounds.diagonal(), 6.0 * i, 20); }); };
  for (int warmUp = 0; warmUp < 4; ++warmUp) fly();
  CHECK(fly() == 0);
  CHECK(stage.editor.fieldsMeasuredBy() == Editor::FieldsFrom::kGpu);
  stage.editor.detachRenderer();
}

#endif
