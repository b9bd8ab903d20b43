#include "cli/layout_command.h"

#include <algorithm>
#include <ostream>

#include "app/composition.h"
#include "app/json.h"
#include "cli/field_measurer.h"
#include "cli/layout_options.h"
#include "cli/load_model.h"
#include "cli/output_file.h"
#include "core/text.h"
#include "placement/placer.h"
#include "render/svg_writer.h"
#include "silhouette/coverage_mask.h"
#include "silhouette/cpu_fields.h"
#include "silhouette/scope_visibility.h"

namespace dimline {

namespace {

constexpr std::string_view kHelp =
    "Usage: dimline layout MODEL [options] -o OUT.json\n\n"
    "Places the dimension lines of a model. MODEL is a built-in name (dimline models lists them), or the path\n"
    "of a .gltf or .glb file.\n\n"
    "  --set NAME=VALUE     a parameter's value, in its own unit; repeatable\n"
    "  --cameras CAMS.json  the cameras, an array of objects such as\n"
    "                       {\"eye\":[10,8,14],\"target\":[0,3,0],\"up\":[0,1,0],\"fovDeg\":35}, or with\n"
    "                       \"orthoHeight\" in place of \"fovDeg\"; their frames follow each other as in a page\n"
    "  --eye x,y,z --target x,y,z [--fov DEGREES | --ortho HEIGHT]\n"
    "                       one camera instead; without any: the three-quarter view in which the page opens\n"
    "  --size WxH           the viewport in pixels, 1000x1000 unless told\n"
    "  --fields cpu|gpu     what measures the silhouette, cpu unless told\n"
    "  --masks FOLDER       also writes FOLDER/0000.pgm and so on: what the model covers, 255 where it is\n"
    "  --svg FOLDER         also writes FOLDER/0000.svg and so on: the dimensioned drawings\n"
    "  -o OUT.json          where the layout goes; - is standard output\n\n"
    "OUT.json holds the model's name, its parameters, bounds (m) and scopes, and the frames, one a camera, each as the type\n"
    "Frame in web/dimline_editor.d.ts says.\n";

/// Everything that one run works on.
struct Job {
  LayoutOptions options;
  Model model;
  Values values;
  Scene scene;
  std::vector<Camera> cameras;
};

Status findCameras(Job& job) {
  const LayoutOptions& options = job.options;
  if (options.camerasPath) {
    constexpr std::size_t kMostBytes = std::size_t{64} << 20U;   // some hundred thousand cameras
    const auto text = readFile(*options.camerasPath, kMostBytes);
    if (!text) return text.error();
    auto cameras = readCameras(*text);
    if (!cameras) return Error{*options.camerasPath + ": " + cameras.error().message};
    job.cameras = std::move(cameras).value();
  } else {
    job.cameras = {options.camera.value_or(threeQuarterView(job.scene.bounds, options.widthPx, options.heightPx))};
  }
  return okStatus();
}

std::string numbered(const std::string& folder, std::size_t frame, std::string_view ending) {
  std::string number = std::to_string(frame);
  if (number.size() < 4) number.insert(0, 4 - number.size(), '0');
  return folder + "/" + number + std::string(ending);
}

Status writeMask(const std::string& path, const CoverageMask& mask) {
  std::string bytes = "P5\n" + std::to_string(mask.widthPx) + " " + std::to_string(mask.heightPx) + "\n255\n";
  bytes.append(mask.pixels.begin(), mask.pixels.end());
  return writeFile(path, bytes);
}

void writeScopes(const Job& job, JsonWriter& json) {
  json.key("scopes").beginArray();
  for (const Scope& scope : job.scene.scopes) {
    const auto names = [&](const std::optional<Annotation>& annotation) {
      return annotation && annotation->scope == scope.name;
    };
    if (std::none_of(job.model.annotations.begin(), job.model.annotations.end(), names)) continue;
    json.beginObject();
    json.key("name").value(scope.name);
    json.key("index").value(static_cast<std::size_t>(scope.index));
    json.key("origin").value(scope.box.origin);
    json.key("axes").beginArray();
    for (const Vec3& axis : scope.box.axes) json.value(axis);
    json.endArray();
    json.key("size").value(scope.box.size);
    json.endObject();
  }
  json.endArray();
}

void writeHeader(const Job& job, JsonWriter& json) {
  json.key("model").value(job.model.definition.name);
  json.key("parameters");
  writeValues(json, job.model.parameters(), job.values);
  json.key("bounds")
      .beginObject()
      .key("min")
      .value(job.scene.bounds.min)
      .key("max")
      .value(job.scene.bounds.max)
      .endObject();
  writeScopes(job, json);
}

/// The CPU's fields want nothing of the machine.
Error withoutGpu(const Error& error) { return {error.message + " Or use --fields cpu."}; }

/// Lays out one frame after the other. Pictures are written as they are made; the JSON when all is well.
Status layOut(Job& job, FieldMeasurer& measurer, JsonWriter& json) {
  const LayoutOptions& options = job.options;
  Placer placer;
  placer.setScene(job.model, job.scene);
  CpuVisibility visibility;
  ScopeVisibility seen;
  DistanceFields fields;
  Layout layout;
  if (!options.camerasPath && !options.camera) {
    // As the page opens: centred with its lines.
    const View view(job.cameras[0], options.widthPx, options.heightPx, job.scene.bounds);
    CpuFields onCpu;
    onCpu.setScene(job.scene);
    onCpu.produce(view, fields);
    job.cameras[0] = composed(view, fields, job.scene, job.values, placer);
  }
  json.key("frames").beginArray();
  for (std::size_t i = 0; i < job.cameras.size(); ++i) {
    const View view(job.cameras[i], options.widthPx, options.heightPx, job.scene.bounds);
    if (Status status = measurer.measure(view, fields); !status) return withoutGpu(status.error());
    visibility.measure(job.scene, view, seen);
    placer.place(view, fields, job.values, layout, &seen);
    if (i == 0 || placer.anew()) placer.placeSettled(view, fields, job.values, layout, &seen);   // as in the page
    writeFrame(json, job.model, job.scene, layout);
    if (options.masksFolder) {
      const Status status = writeMask(numbered(*options.masksFolder, i, ".pgm"), coverageMask(job.scene, view));
      if (!status) return status;
    }
    if (options.svgFolder) {
      const std::string drawing = writeSvg(job.scene, layout, job.model.definition.title);
      if (Status status = writeFile(numbered(*options.svgFolder, i, ".svg"), drawing); !status) return status;
    }
  }
  json.endArray();
  return okStatus();
}

Status makeFolders(const LayoutOptions& options) {
  for (const auto& folder : {options.masksFolder, options.svgFolder}) {
    if (!folder) continue;
    if (Status status = makeFolder(*folder); !status) return status;
  }
  return okStatus();
}

Outcome run(std::span<const std::string_view> arguments, const Streams& streams) {
  auto options = parseLayoutOptions(arguments);
  if (!options) return badArguments(options.error().message);
  Job job;
  job.options = std::move(options).value();
  auto model = loadModel(job.options.model, streams.err);
  if (!model) return badInput(model.error());
  job.model = std::move(model).value();
  auto values = valuesOf(job.model, job.options.values);
  if (!values) return badInput(values.error());
  job.values = std::move(values).value();
  job.scene = job.model.definition.build(job.values);
  if (Status status = findCameras(job); !status) return badInput(status.error());

  std::unique_ptr<FieldMeasurer> measurer;
  if (job.options.gpuFields) {
    auto made = FieldMeasurer::onGpu(job.scene);
    if (!made) return badInput(withoutGpu(made.error()));
    measurer = std::move(made).value();
  } else {
    measurer = FieldMeasurer::onCpu(job.scene);
  }

  if (Status status = makeFolders(job.options); !status) return badInput(status.error());
  const bool toStream = job.options.outputPath == "-";
  // Or drawings would be left by a run that failed.
  if (Status status = toStream ? okStatus() : checkWritable(job.options.outputPath); !status) return badInput(status.error());
  JsonWriter json;
  json.beginObject();
  writeHeader(job, json);
  if (Status status = layOut(job, *measurer, json); !status) return badInput(status.error());
  json.endObject();
  if (toStream) {
    streams.out << json.text() << "\n";
    return std::nullopt;
  }
  if (Status status = writeFile(job.options.outputPath, json.text() + "\n"); !status) return badInput(status.error());
  return std::nullopt;
}

}  // namespace

Command layoutCommand() {
  return {"layout", "dimension lines for given cameras, as JSON, masks and drawings", kHelp, run};
}

}  // namespace dimline
