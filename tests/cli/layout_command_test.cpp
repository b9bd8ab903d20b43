#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include <catch2/catch.hpp>

#include "cli/run_program.h"

namespace dimline::test {
namespace {

using nlohmann::json;

/// The JSON of a run that must go well.
json layoutOf(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), "layout");
  arguments.insert(arguments.end(), {"-o", "-"});
  const Run run = runProgram(arguments);
  INFO(run.err);
  REQUIRE(run.status == 0);
  return parsed(run.out);
}

/// Runs `dimline layout` with the arguments, which must fail without writing anything.
Run failing(std::vector<std::string> arguments) {
  const TemporaryFolder folder;
  arguments.insert(arguments.begin(), "layout");
  arguments.insert(arguments.end(), {"-o", folder / "out.json"});
  Run run = runProgram(arguments);
  CHECK(run.out.empty());
  CHECK(folder.list().empty());
  // One sentence, and for a wrong command line where to read on.
  CHECK(run.err.starts_with("dimline layout: "));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == (run.status == 2 ? 2 : 1));
  return run;
}

const std::string kTwoCameras =
    R"([{"eye":[20,8,25],"target":[0,3,0],"up":[0,1,0],"fovDeg":35},{"eye":[-25,12,20],"target":[0,3,0],"orthoHeight":18}])";

TEST_CASE("a layout holds what the contract says") {
  const TemporaryFolder folder;
  const std::string cameras = folder.file("cameras.json", kTwoCameras);
  const json layout = layoutOf({"house", "--cameras", cameras, "--size", "900x700"});
  CHECK(layout["model"] == "house");
  CHECK(layout["parameters"].is_object());
  for (int i = 0; i < 3; ++i)
    CHECK(layout["bounds"]["min"][i].get<double>() < layout["bounds"]["max"][i].get<double>());

  const json models = parsed(runProgram({"models", "--json"}).out);
  std::set<std::string> annotated;
  for (const json& parameter : models[0]["parameters"]) {
    if (!parameter["annotation"].get<std::string>().empty()) annotated.insert(parameter["name"]);
    CHECK(layout["parameters"][parameter["name"].get<std::string>()] == parameter["default"]);
  }
  REQUIRE(!layout["scopes"].empty());
  for (const json& scope : layout["scopes"]) {
    CHECK(scope["name"].is_string());
    CHECK(scope["index"].is_number_integer());
    CHECK(scope["axes"].size() == 3);
    CHECK(scope["size"].size() == 3);
  }

  REQUIRE(layout["frames"].size() == 2);
  for (const json& frame : layout["frames"]) {
    CHECK(frame["size"] == json({900, 700}));
    CHECK(frame["view"].size() == 16);
    CHECK(frame["projection"].size() == 16);
    std::set<std::string> shown;
    for (const json& line : frame["lines"]) {
      shown.insert(line["parameter"]);
      CHECK((line["placement"] == "outside" || line["placement"] == "guide" || line["placement"] == "inside"));
      CHECK(line["line"]["world"].size() == 2);
      CHECK(line["base"]["screen"].size() == 2);
      CHECK(line["identity"].is_string());
      CHECK(annotated.contains(line["parameter"]));
    }
    std::set<std::string> hidden;
    for (const json& entry : frame["hidden"]) hidden.insert(entry["parameter"]);
    for (const std::string& name : shown) CHECK_FALSE(hidden.contains(name));
    CHECK(!shown.empty());
  }
  // The second camera is orthographic: the last row of its projection is 0 0 0 1.
  CHECK(layout["frames"][0]["projection"][15].get<double>() == 0);
  CHECK(layout["frames"][1]["projection"][15].get<double>() == 1);
}

TEST_CASE("world and screen positions of a line agree through the matrices") {
  const json frame = layoutOf({"house"})["frames"][0];
  const auto& v = frame["view"];
  const auto& p = frame["projection"];
  const double width = frame["size"][0], height = frame["size"][1];
  REQUIRE(!frame["lines"].empty());
  for (const json& line : frame["lines"]) {
    for (const char* which : {"base", "line"}) {
      for (std::size_t end = 0; end < 2; ++end) {
        const json& world = line[which]["world"][end];
        double eye[4], clip[4];
        const double at[4] = {world[0], world[1], world[2], 1};
        for (std::size_t r = 0; r < 4; ++r) {
          eye[r] = 0;
          for (std::size_t c = 0; c < 4; ++c) eye[r] += v[c * 4 + r].get<double>() * at[c];
        }
        for (std::size_t r = 0; r < 4; ++r) {
          clip[r] = 0;
          for (std::size_t c = 0; c < 4; ++c) clip[r] += p[c * 4 + r].get<double>() * eye[c];
        }
        const json& screen = line[which]["screen"][end];
        CHECK(screen[0].get<double>() == Approx((clip[0] / clip[3] + 1) / 2 * width).margin(1e-6));
        CHECK(screen[1].get<double>() == Approx((1 - clip[1] / clip[3]) / 2 * height).margin(1e-6));
      }
    }
  }
}

TEST_CASE("two runs give the same bytes") {
  const TemporaryFolder folder;
  const std::string cameras = folder.file("cameras.json", kTwoCameras);
  const std::vector<std::string> arguments = {"layout", "house", "--cameras", cameras, "-o", "-"};
  const Run first = runProgram(arguments), second = runProgram(arguments);
  REQUIRE(first.status == 0);
  CHECK(first.out == second.out);
}

TEST_CASE("values are set in the parameter's own unit, off-step too, and show in the labels") {
  const json models = parsed(runProgram({"models", "--json"}).out);
  const auto& parameters = models[0]["parameters"];
  const auto found = std::find_if(parameters.begin(), parameters.end(), [](const json& p) {
    return p["type"] == "float" && p["unit"] == "m" && p["step"].get<double>() > 0.004;
  });
  REQUIRE(found != parameters.end());
  const std::string name = (*found)["name"];
  const double value = (*found)["default"].get<double>() + 0.003;
  const json layout = layoutOf({"house", "--set", name + "=" + std::to_string(value)});
  CHECK(layout["parameters"][name].get<double>() == Approx(value));
  for (const json& line : layout["frames"][0]["lines"]) {
    if (line["parameter"] == name) CHECK(line["value"].get<double>() == Approx(value));
  }
  const json again =
      layoutOf({"house", "--set=" + name + "=" + std::to_string(value), "--set", name + "=" + (*found)["max"].dump()});
  CHECK(again["parameters"][name] == (*found)["max"]);  // the last one counts
}

TEST_CASE("masks are binary PGM, 255 where the model is") {
  const TemporaryFolder folder;
  const std::string cameras = folder.file("cameras.json", kTwoCameras);
  layoutOf({"house", "--cameras", cameras, "--size", "200x150", "--masks", folder / "deep/masks"});
  CHECK(folder.list("deep/masks") == std::vector<std::string>{"0000.pgm", "0001.pgm"});
  for (const char* name : {"deep/masks/0000.pgm", "deep/masks/0001.pgm"}) {
    const std::string mask = contentOf(folder / name);
    const std::string header = "P5\n200 150\n255\n";
    REQUIRE(mask.substr(0, header.size()) == header);
    REQUIRE(mask.size() == header.size() + 200 * 150);
    const auto covered = std::count(mask.begin() + static_cast<std::ptrdiff_t>(header.size()), mask.end(), '\xff');
    const auto empty = std::count(mask.begin() + static_cast<std::ptrdiff_t>(header.size()), mask.end(), '\0');
    CHECK(covered + empty == 200 * 150);
    CHECK(covered > 1000);
    CHECK(empty > 1000);
    // Both cameras look at the middle of the house.
    CHECK(mask[header.size() + 75 * 200 + 100] == '\xff');
  }
}

TEST_CASE("drawings are SVG documents, one a camera") {
  const TemporaryFolder folder;
  const std::string cameras = folder.file("cameras.json", kTwoCameras);
  const json layout = layoutOf({"house", "--cameras", cameras, "--size", "500x400", "--svg", folder / "drawings"});
  CHECK(folder.list("drawings") == std::vector<std::string>{"0000.svg", "0001.svg"});
  for (std::size_t i = 0; i < 2; ++i) {
    const std::string svg = contentOf(folder / ("drawings/000" + std::to_string(i) + ".svg"));
    CHECK(svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"500\" height=\"400\""));
    CHECK(svg.ends_with("</svg>\n"));
    for (const json& line : layout["frames"][i]["lines"]) {
      if (!line["label"].is_null())
        CHECK(svg.find(">" + line["text"].get<std::string>() + "</text>") != std::string::npos);
    }
  }
}

TEST_CASE("a glTF file is a model like any other") {
  const json layout = layoutOf({DIMLINE_TEST_DATA_DIR "/gltf/chair_A.gltf", "--set", "Height=2"});
  CHECK(layout["model"] == "chair_A");
  CHECK(layout["parameters"]["Width"].get<double>() == 0.75);
  CHECK(layout["bounds"]["max"][1].get<double>() - layout["bounds"]["min"][1].get<double>() == Approx(2));
  REQUIRE(layout["scopes"].size() == 1);
  CHECK(layout["scopes"][0]["name"] == "Model");
  CHECK(layout["frames"][0]["lines"].size() + layout["frames"][0]["hidden"].size() == 3);
}

TEST_CASE("GPU fields give a layout too") {
  const json layout = layoutOf({"house", "--fields", "gpu", "--size", "600x600"});
  CHECK(!layout["frames"][0]["lines"].empty());
}

TEST_CASE("GPU fields where there is no GL are an error that names the way out") {
  // The loader of EGL drivers then finds none.
  const Run run =
      runProgram({"layout", "house", "--fields", "gpu", "-o", "-"}, {{"__EGL_VENDOR_LIBRARY_FILENAMES", "/dev/null"}});
  CHECK(run.status == 1);
  CHECK(run.out.empty());
  CHECK(run.err.find("use --fields cpu.\n") != std::string::npos);
}

TEST_CASE("an output file is written whole or not at all") {
  const TemporaryFolder folder;
  const std::string old = folder.file("out.json", "what was there");
  const std::string bad =
      folder.file("cameras.json", R"([{"eye":[20,8,25],"target":[0,3,0]},{"eye":[1,1,1],"target":[1,1,1]}])");
  CHECK(runProgram({"layout", "house", "--cameras", bad, "-o", old}).status == 1);
  CHECK(contentOf(old) == "what was there");

  CHECK(runProgram({"layout", "house", "-o", old}).status == 0);
  CHECK(parsed(contentOf(old))["model"] == "house");
  CHECK(folder.list() == std::vector<std::string>{"cameras.json", "out.json"});  // nothing left beside them

  const Run nowhere = runProgram({"layout", "house", "-o", folder / "no/such/folder/out.json"});
  CHECK(nowhere.status == 1);
  CHECK(nowhere.err == "dimline layout: Cannot write \"" +
                           std::string(folder / "no/such/folder/out.json").substr(0, 40) +
                           "\xE2\x80\xA6\": No such file or directory.\n");
  const Run onFolder = runProgram({"layout", "house", "-o", folder / ""});
  CHECK(onFolder.status == 1);
  CHECK(onFolder.err.find("Is a directory") != std::string::npos);
  // Nor are drawings left of a run that cannot write its layout.
  CHECK(runProgram({"layout", "house", "--svg", folder / "drawings", "-o", folder / "no/such/folder/out.json"}).status == 1);
  CHECK(std::filesystem::is_empty(std::filesystem::path(folder / "drawings")));
  const Run masksOnFile = runProgram({"layout", "house", "--masks", old, "-o", "-"});
  CHECK(masksOnFile.status == 1);
}

TEST_CASE("an output that is a link stays one, and a file keeps its permissions") {
  namespace fs = std::filesystem;
  const TemporaryFolder folder;
  const std::string target = folder.file("target.json", "what was there");
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("target.json", folder / "link.json");
  CHECK(runProgram({"layout", "house", "-o", folder / "link.json"}).status == 0);
  CHECK(fs::is_symlink(folder / "link.json"));
  CHECK(parsed(contentOf(target))["model"] == "house");
  CHECK(fs::status(target).permissions() == (fs::perms::owner_read | fs::perms::owner_write));

  const std::string longest = folder / (std::string(250, 'a') + ".json");
  CHECK(runProgram({"layout", "house", "-o", longest}).status == 0);
}

TEST_CASE("a model file of any name gives well-formed text") {
  const TemporaryFolder folder;
  const std::string model = folder.file("b\xE9\x01.gltf", contentOf(DIMLINE_TEST_DATA_DIR "/gltf/chair_A.gltf"));
  for (const char* beside : {"chair_A.bin", "furniturebits_texture.png"}) (void)folder.file(beside, contentOf(std::string(DIMLINE_TEST_DATA_DIR "/gltf/") + beside));
  CHECK(layoutOf({model, "--svg", folder / "drawings"})["model"] == "b\xEF\xBF\xBD\xEF\xBF\xBD");
  CHECK(contentOf(folder / "drawings/0000.svg").find("b\xEF\xBF\xBD\xEF\xBF\xBD") != std::string::npos);
  CHECK(runProgram({"export", model, "-o", folder / "out.glb"}).status == 0);
}

TEST_CASE("cameras from the command line are like those from a file") {
  const TemporaryFolder folder;
  const std::string cameras = folder.file("cameras.json", R"([{"eye":[20,8,25],"target":[0,3,0],"fovDeg":40}])");
  const json byFile = layoutOf({"house", "--cameras", cameras});
  const json byArguments = layoutOf({"house", "--eye", "20,8,25", "--target", "0,3,0", "--fov", "40"});
  CHECK(byFile == byArguments);
  const json orthographic = layoutOf({"house", "--eye=-20,8,25", "--target", "0,3,0", "--ortho", "15"});
  CHECK(orthographic["frames"][0]["projection"][5].get<double>() == Approx(2.0 / 15));
}

TEST_CASE(
    "odd viewports and cameras give a layout: tiny, flat, inside the house, far away, looking down, looking away") {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--size", "1x1"},
                                             {"--size", "3000x20"},
                                             {"--eye", "0,1.5,0", "--target", "1,1.5,0"},
                                             {"--eye", "5000,3000,5000", "--target", "0,0,0"},
                                             {"--eye", "0,40,0", "--target", "0,0,0"},
                                             {"--eye", "0,3,40", "--target", "0,3,80"},
                                             {"--eye", "0,3,40", "--target", "0,3,0", "--fov", "179"}}) {
    std::vector<std::string> all = {"house"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const json layout = layoutOf(all);
    CHECK(layout["frames"].size() == 1);
    for (const json& line : layout["frames"][0]["lines"]) {
      for (const json& p : line["line"]["screen"]) {
        CHECK(p[0].is_number());  // what is not finite would be null
        CHECK(p[1].is_number());
      }
    }
  }
}

TEST_CASE("no cameras, no frames") {
  const TemporaryFolder folder;
  CHECK(layoutOf({"house", "--cameras", folder.file("none.json", "[]")})["frames"] == json::array());
}

// --- What is wrong ------------------------------------------------------------------------------------------------------

TEST_CASE("a command line that is wrong: status 2") {
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
      {{}, "Name a model"},
      {{"house", "boat"}, "One model at a time: \"boat\""},
      {{"house", "--sice", "3x3"}, "There is no option \"--sice\""},
      {{"house", "--size"}, "--size needs a value: --size WxH."},
      {{"house", "--size", "--fov", "3"}, "--size needs a value"},
      {{"house", "--size", "800"}, "such as 1000x800, not \"800\"."},
      {{"house", "--size", "0x0"}, "each from 1 to 16384"},
      {{"house", "--size", "800x0"}, "each from 1 to 16384"},
      {{"house", "--size", "-800x600"}, "each from 1 to 16384"},
      {{"house", "--size", "99999x10"}, "each from 1 to 16384"},
      {{"house", "--size", "8e2x600"}, "each from 1 to 16384"},
      {{"house", "--size", "8x6", "--size", "8x6"}, "--size is given twice."},
      {{"house", "--set", "Width"}, "--set takes NAME=VALUE"},
      {{"house", "--set", "=4"}, "--set takes NAME=VALUE"},
      {{"house", "--fields", "fpga"}, "--fields takes cpu or gpu, not \"fpga\"."},
      {{"house", "--eye", "1,2,3"}, "both --eye and --target"},
      {{"house", "--fov", "40"}, "both --eye and --target"},
      {{"house", "--eye", "1,2", "--target", "0,0,0"}, "--eye takes three numbers, such as 10,8,14, not \"1,2\"."},
      {{"house", "--eye", "1,2,3,4", "--target", "0,0,0"}, "--eye takes three numbers"},
      {{"house", "--eye", "nan,2,3", "--target", "0,0,0"}, "--eye takes three numbers"},
      {{"house", "--eye", "1,2,3", "--target", "0,inf,0"}, "--target takes three numbers"},
      {{"house", "--eye", "1,2,3", "--target", "1,2,3"}, "the same point"},
      {{"house", "--eye", "1,2,3", "--target", "0,0,0", "--fov", "200"}, "between 0 and 180 degrees"},
      {{"house", "--eye", "1,2,3", "--target", "0,0,0", "--fov", "wide"}, "--fov takes a number, not \"wide\"."},
      {{"house", "--eye", "1,2,3", "--target", "0,0,0", "--ortho", "0"}, "positive number"},
      {{"house", "--eye", "1,2,3", "--target", "0,0,0", "--ortho", "5", "--fov", "30"}, "give one of them"},
      {{"house", "--cameras", "c.json", "--fov", "30"}, "--cameras says all"}};
  for (const auto& [arguments, words] : cases) {
    const Run run = failing(arguments);
    INFO(run.err);
    CHECK(run.status == 2);
    CHECK(run.err.find(words) != std::string::npos);
  }
  const Run noOutput = runProgram({"layout", "house"});
  CHECK(noOutput.status == 2);
  CHECK(noOutput.err.find("-o is missing") != std::string::npos);
}

TEST_CASE("a model or a value that cannot be used: status 1") {
  const Run unknown = failing({"hose"});
  CHECK(unknown.status == 1);
  CHECK(unknown.err.find("\"hose\"") != std::string::npos);
  CHECK(unknown.err.find("house") != std::string::npos);

  const json models = parsed(runProgram({"models", "--json"}).out);
  const json& parameters = models[0]["parameters"];
  const auto first = [&](const char* type) {
    for (const json& p : parameters) {
      if (p["type"] == type) return p;
    }
    FAIL("the house has no parameter of type " << type);
    return json();
  };
  const json length = first("float"), roof = first("choice"), flag = first("bool"), count = first("int");
  const auto set = [&](const json& parameter, const std::string& value) {
    const Run run = failing({"house", "--set", parameter["name"].get<std::string>() + "=" + value});
    CHECK(run.status == 1);
    CHECK(run.err.find(parameter["name"].get<std::string>()) != std::string::npos);
    return run.err;
  };
  CHECK(set(length, "1000").find("must lie between") != std::string::npos);
  CHECK(set(length, "-3").find("must lie between") != std::string::npos);
  CHECK(set(length, "nan").find("takes a number") != std::string::npos);
  CHECK(set(length, "inf").find("takes a number") != std::string::npos);
  CHECK(set(length, "").find("takes a number") != std::string::npos);
  CHECK(set(length, "9,5").find("takes a number") != std::string::npos);
  CHECK(set(count, "1.5").find("whole number") != std::string::npos);
  CHECK(set(flag, "perhaps").find("true or false") != std::string::npos);
  CHECK(set(roof, "onion").find(roof["choices"][0].get<std::string>()) != std::string::npos);

  const Run noParameter = failing({"house", "--set", "Wings=3"});
  CHECK(noParameter.status == 1);
  CHECK(noParameter.err.find("no parameter \"Wings\"; it has ") != std::string::npos);

  const TemporaryFolder folder;
  CHECK(failing({folder / "none.glb"}).status == 1);
  CHECK(failing({folder.file("broken.glb", "glTF and then nothing")}).status == 1);
}

TEST_CASE("of a file of cameras that has no end no more is read than makes sense") {
  const Run run = failing({"house", "--cameras", "/dev/zero"});
  CHECK(run.status == 1);
  CHECK(run.err.find("\"/dev/zero\" has more than 64 MB") != std::string::npos);
}

TEST_CASE("a drawing of what is seen from nearly no angle has numbers alone in it") {
  const TemporaryFolder folder;
  layoutOf({"single-tree", "--eye", "10,8,14", "--target", "0,3,0", "--fov", "1e-7", "--svg", folder / "drawings"});
  const std::string svg = contentOf(folder / "drawings/0000.svg");
  CHECK(svg.find("nan") == std::string::npos);
  CHECK(svg.find("inf") == std::string::npos);
}

TEST_CASE("cameras that cannot be used: status 1, and which one it is") {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "there is no text"},
      {"[{", "not valid JSON at line 1, column 2"},
      {"[{\"eye\":[1,2,3],\n  \"target\":[0,0,0],}]", "line 2, column 21"},
      {"{}", "list"},
      {"[3]", "Camera 0"},
      {R"([{"eye":[1,2,3],"target":[0,0,0]},{"eye":[1,2,3]}])", "Camera 1"},
      {R"([{"eye":[1,2],"target":[0,0,0]}])", "eye"},
      {R"([{"eye":[1,2,"3"],"target":[0,0,0]}])", "eye"},
      {R"([{"eye":[1,2,NaN],"target":[0,0,0]}])", "not valid JSON"},
      {R"([{"eye":[1,2,1e999],"target":[0,0,0]}])", ""},
      {R"([{"eye":[1,2,3],"target":[1,2,3]}])", "same point"},
      {R"([{"eye":[1,2,3],"target":[0,0,0],"up":[0,0,0]}])", "up"},
      {R"([{"eye":[1,2,3],"target":[0,0,0],"fovDeg":-4}])", "0 and 180"},
      {R"([{"eye":[1,2,3],"target":[0,0,0],"fovDeg":"wide"}])", "fovDeg"},
      {R"([{"eye":[1,2,3],"target":[0,0,0],"orthoHeight":0}])", "orthoHeight"},
      {R"([{"eye":[1,2,3],"target":[0,0,0],"orthoHeight":5,"fovDeg":30}])", "not both"},
      {R"([{"eye":[1,2,3],"target":[0,0,0],"fow":30}])", "fow"}};
  for (const auto& [text, words] : cases) {
    INFO(text);
    const TemporaryFolder folder;
    const std::string path = folder.file("cameras.json", text);
    const Run run = failing({"house", "--cameras", path});
    INFO(run.err);
    CHECK(run.status == 1);
    CHECK(run.err.find("cameras.json") != std::string::npos);
    CHECK(run.err.find(words) != std::string::npos);
  }
  const Run missing = failing({"house", "--cameras", "no-such-file.json"});
  CHECK(missing.status == 1);
  CHECK(missing.err == "dimline layout: Cannot read \"no-such-file.json\": No such file or directory.\n");
}

}  // namespace
}  // namespace dimline::test
