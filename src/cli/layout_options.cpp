#include "cli/layout_options.h"

#include "cli/arguments.h"
#include "cli/load_model.h"
#include "cli/size_text.h"
#include "core/text.h"

namespace dimline {

namespace {

constexpr OptionRule kRules[] = {kSetRule,
                                 {"--cameras", OptionRule::Kind::kValue, "CAMS.json"},
                                 {"--eye", OptionRule::Kind::kValue, "x,y,z"},
                                 {"--target", OptionRule::Kind::kValue, "x,y,z"},
                                 {"--fov", OptionRule::Kind::kValue, "DEGREES"},
                                 {"--ortho", OptionRule::Kind::kValue, "HEIGHT"},
                                 {"--size", OptionRule::Kind::kValue, "WxH"},
                                 {"--fields", OptionRule::Kind::kValue, "cpu|gpu"},
                                 {"--masks", OptionRule::Kind::kValue, "FOLDER"},
                                 {"--svg", OptionRule::Kind::kValue, "FOLDER"},
                                 {"-o", OptionRule::Kind::kValue, "OUT.json"}};

Result<Vec3> parseVec3(std::string_view option, std::string_view text) {
  Vec3 v(0.0);
  std::string_view rest = text;
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = rest.find(',');
    const bool last = comma == std::string_view::npos;
    const auto number = parseDouble(trim(rest.substr(0, comma)));
    if (!number || last != (i == 2)) {
      return Error{std::string(option) + " takes three numbers, such as 10,8,14, not " + inQuotes(text) + "."};
    }
    v[i] = *number;
    rest.remove_prefix(last ? rest.size() : comma + 1);
  }
  return v;
}

Result<double> parseNumber(std::string_view option, std::string_view text) {
  const auto number = parseDouble(trim(text));
  if (!number) return Error{std::string(option) + " takes a number, not " + inQuotes(text) + "."};
  return *number;
}

Status readSize(const Arguments& arguments, LayoutOptions& options) {
  const auto text = arguments.value("--size");
  if (!text) return okStatus();
  const auto size = parseSize(*text, kMaxSidePx);
  if (!size) return size.error();
  options.widthPx = size->widthPx;
  options.heightPx = size->heightPx;
  return okStatus();
}

Status readCamera(const Arguments& arguments, LayoutOptions& options) {
  const auto eye = arguments.value("--eye"), target = arguments.value("--target");
  const auto fov = arguments.value("--fov"), ortho = arguments.value("--ortho");
  if (const auto path = arguments.value("--cameras")) {
    if (eye || target || fov || ortho)
      return Error{"--cameras says all about the cameras; leave --eye, --target, --fov and --ortho out."};
    options.camerasPath = std::string(*path);
    return okStatus();
  }
  if (!eye && !target && !fov && !ortho) return okStatus();
  if (!eye || !target) return Error{"A camera needs both --eye and --target."};
  if (fov && ortho)
    return Error{"--fov is for a perspective camera and --ortho for an orthographic one; give one of them."};

  Camera camera;
  const auto eyeAt = parseVec3("--eye", *eye), targetAt = parseVec3("--target", *target);
  if (!eyeAt) return eyeAt.error();
  if (!targetAt) return targetAt.error();
  camera.eye = *eyeAt;
  camera.target = *targetAt;
  if (fov) {
    const auto degrees = parseNumber("--fov", *fov);
    if (!degrees) return degrees.error();
    camera.fovRad = *degrees * kRadPerDeg;
  }
  if (ortho) {
    const auto heightM = parseNumber("--ortho", *ortho);
    if (!heightM) return heightM.error();
    camera.orthoHeightM = *heightM;
  }
  if (Status status = validate(camera); !status) return status.error();
  options.camera = camera;
  return okStatus();
}

Status readOutputs(const Arguments& arguments, LayoutOptions& options) {
  const auto readPath = [&](std::string_view option, std::optional<std::string>& path) -> Status {
    const auto value = arguments.value(option);
    if (!value) return okStatus();
    if (value->empty()) return Error{std::string(option) + " needs a path that is not empty."};
    path = std::string(*value);
    return okStatus();
  };
  if (Status status = readPath("--masks", options.masksFolder); !status) return status;
  if (Status status = readPath("--svg", options.svgFolder); !status) return status;
  std::optional<std::string> output;
  if (Status status = readPath("-o", output); !status) return status;
  if (!output) return Error{"-o is missing: say where the layout shall be written, as in -o OUT.json."};
  options.outputPath = *output;
  return okStatus();
}

}  // namespace

Result<LayoutOptions> parseLayoutOptions(std::span<const std::string_view> list) {
  const auto arguments = Arguments::parse(list, kRules);
  if (!arguments) return arguments.error();
  const auto model = modelArgument(*arguments);
  if (!model) return model.error();
  auto assignments = assignmentsOf(*arguments);
  if (!assignments) return assignments.error();

  LayoutOptions options;
  options.model = *model;
  options.values = std::move(assignments).value();
  if (const auto fields = arguments->value("--fields")) {
    if (*fields != "cpu" && *fields != "gpu") return Error{"--fields takes cpu or gpu, not " + inQuotes(*fields) + "."};
    options.gpuFields = *fields == "gpu";
  }
  if (Status status = readSize(*arguments, options); !status) return status.error();
  if (Status status = readCamera(*arguments, options); !status) return status.error();
  if (Status status = readOutputs(*arguments, options); !status) return status.error();
  return options;
}

}  // namespace dimline
