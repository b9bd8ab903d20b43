#include <algorithm>
#include <map>
#include <string>

#include <catch2/catch.hpp>

#include "cli/audit_rows.h"
#include "cli/run_program.h"

namespace dimline::test {
namespace {

TEST_CASE("dimline audit prints a table, and the same as JSON") {
  const std::vector<std::string> plan{"--step", "30", "--every", "6", "--worst", "2", "--size", "500x500"};
  std::vector<std::string> arguments{"audit", "house"};
  arguments.insert(arguments.end(), plan.begin(), plan.end());
  const Run table = runProgram(arguments);
  REQUIRE(table.status == 0);
  CHECK(table.out.find("outside lines that cross the model") != std::string::npos);
  CHECK(table.out.find("of 17 aims met.") != std::string::npos);

  arguments.emplace_back("--json");
  const Run run = runProgram(arguments);
  REQUIRE(run.status == 0);
  const auto audits = parsed(run.out);
  REQUIRE(audits.size() == 1);
  CHECK(audits[0]["model"] == "house");
  REQUIRE(audits[0]["parts"].size() == 1);
  const auto& part = audits[0]["parts"][0];
  CHECK(part["part"] == "orbits");
  CHECK(part["frames"] == 36);
  REQUIRE(part["rows"].size() == kAuditRowCount);
  for (const auto& row : part["rows"]) {
    INFO(row.dump());
    for (const char* key : {"row", "title", "figure", "figure95", "aim", "aim95", "met", "judged", "offences", "atOdds",
                            "frozen", "worst"}) {
      CHECK(row.contains(key));
    }
    CHECK(row["met"].is_boolean());
    CHECK(row["figure"].is_null() == (row["judged"] == 0));
    CHECK(row["worst"].size() <= 2);
    CHECK(row["worst"].empty() == (row["offences"] == 0));
  }
}

TEST_CASE("dimline audit holds each figure against its aim, and beside what lines fixed in the world come to") {
  const auto rows = parsed(runProgram({"audit", "house", "--step", "30", "--size", "500x500", "--json"}).out)[0]["parts"][0]["rows"];
  const std::map<std::string, double> aims{
      {"crosses-model", 0}, {"touches-model", 0},         {"model-distance", 29.5}, {"line-distance", 29.5},
      {"offset", 1.05},     {"line-crossings", 0},        {"extension-crossings", 0.01}, {"label-overlaps", 0},
      {"nesting", 0.01},    {"needlessly-inside", 0},     {"leaves-viewport", 0},   {"identity-changes", 0.02},
      {"flicker", 0},       {"jumps", 0.002},             {"chain-members", 0.02},  {"still-camera", 0},
      {"unshown", 0}};
  REQUIRE(rows.size() == aims.size());
  for (const auto& row : rows) {
    INFO(row.dump());
    CHECK(row["aim"] == Approx(aims.at(row["row"])));
    if (row["row"] == "offset") CHECK(row["aim95"] == Approx(1.5));
  }
  // Seen from elsewhere, lines that stood clear of the house from the front run across it.
  CHECK(rows[0]["offences"] == 0);
  CHECK(rows[0]["frozen"] > 10);
}

TEST_CASE("dimline audit takes extremes, flights and values") {
  const Run run = runProgram({"audit", "lever", "--step", "90", "--every", "4", "--size", "200x200", "--set",
                              "LeverAngle=40", "--extremes", "--flights", "1", "--json"});
  REQUIRE(run.status == 0);
  const auto parts = parsed(run.out)[0]["parts"];
  REQUIRE(parts.size() == 3);
  CHECK(parts[1]["part"] == "extremes");
  CHECK(parts[1]["flights"] == 3 * 2 * 7);  // orbits, ends of a range, parameters
  CHECK(parts[2]["flights"] == 1);
}

TEST_CASE("dimline audit measures the pictures in which a movement rests by themselves") {
  const Run run = runProgram({"audit", "lever", "--step", "10", "--every", "36", "--size", "300x300", "--rests", "60", "--json"});
  REQUIRE(run.status == 0);
  const auto parts = parsed(run.out)[0]["parts"];
  REQUIRE(parts.size() == 2);
  CHECK(parts[1]["part"] == "rests");
  CHECK(parts[1]["frames"] == 3 * 36);
  CHECK(parts[1]["framesMeasured"] == 3 * 6);
  // Between them lie others, so nothing is said of changes from one to the next.
  CHECK(parts[1]["rows"].size() == kAuditRowCount - 4);
  for (const auto& row : parts[1]["rows"]) CHECK(row["row"] != "identity-changes");

  const Run flights = runProgram({"audit", "lever", "--step", "90", "--every", "36", "--size", "300x300", "--rests", "90", "--flights", "1", "--json"});
  const auto flown = parsed(flights.out)[0]["parts"];
  REQUIRE(flown.size() == 4);
  CHECK(flown[3]["part"] == "flight-rests");
  CHECK(flown[3]["frames"] == flown[2]["frames"]);
  CHECK(flown[3]["framesMeasured"] == (flown[3]["frames"].get<int>() + 89) / 90);

  const Run table = runProgram({"audit", "lever", "--step", "10", "--every", "36", "--size", "300x300", "--rests", "60"});
  CHECK(table.out.find("lever, rests: 3 flights, 108 frames, 18 of them") != std::string::npos);
  CHECK(table.out.find(" of 13 aims met.") != std::string::npos);
}

TEST_CASE("dimline audit draws the gravest cases") {
  const TemporaryFolder folder;
  // A step of 40 degrees changes more lines than the aim allows.
  const Run run = runProgram(
      {"audit", "house", "--step", "40", "--every", "9", "--worst", "2", "--size", "500x500", "--svg", folder / "drawings", "--json"});
  REQUIRE(run.status == 0);
  std::size_t listed = 0;
  const auto audits = parsed(run.out);
  for (const auto& row : audits[0]["parts"][0]["rows"]) listed += row["met"] == true ? 0 : row["worst"].size();
  const std::vector<std::string> drawings = folder.list("drawings");
  CHECK(drawings.size() == listed);
  REQUIRE_FALSE(drawings.empty());
  CHECK(std::ranges::find(drawings, "orbits-identity-changes-1.svg") != drawings.end());
  CHECK(contentOf(folder / "drawings/" + drawings[0]).find("<svg") != std::string::npos);
}

TEST_CASE("dimline audit looks after the folder for its drawings before it begins") {
  const TemporaryFolder folder;
  const Run run = runProgram({"audit", "house", "--worst", "2", "--svg", folder.file("drawings", "a file")});
  CHECK(run.status == 1);
  CHECK(run.out.empty());
  CHECK(run.err.find("Cannot make the folder") != std::string::npos);
  CHECK(run.err.find("orbit") == std::string::npos);   // nothing has been flown
}

TEST_CASE("dimline audit says what is wrong with its arguments") {
  CHECK(runProgram({"audit"}).status == 2);
  CHECK(runProgram({"audit", "house", "box"}).status == 2);
  CHECK(runProgram({"audit", "house", "--every", "0"}).status == 2);
  const Run rests = runProgram({"audit", "house", "--rests", "often"});
  CHECK(rests.status == 2);
  CHECK(rests.err.find("--rests takes degrees from 0.05 to 360") != std::string::npos);
  CHECK(runProgram({"audit", "house", "--step", "x"}).status == 2);
  CHECK(runProgram({"audit", "house", "--size", "10"}).status == 2);
  CHECK(runProgram({"audit", "house", "--svg", "drawings"}).status == 2);
  CHECK(runProgram({"audit", "all", "--set", "Width=9"}).status == 2);
  CHECK(runProgram({"audit", "nothing"}).status == 1);
  CHECK(runProgram({"audit", "house", "--set", "Nothing=3"}).status == 1);
  CHECK(runProgram({"audit", "house", "--set", "Width=1e9"}).status == 1);
}

}  // namespace
}  // namespace dimline::test
