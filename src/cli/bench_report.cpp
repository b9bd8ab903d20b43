#include "cli/bench_report.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iomanip>
#include <ostream>
#include <string_view>

#include "cli/bench_scenes.h"
#include "core/text.h"

namespace dimline {

namespace {

constexpr int kNameWidth = 14;
constexpr int kCountWidth = 10;
constexpr int kTimeWidth = 13;

/// A row of the paper's table 1, measured on an iMac of 2012. A negative time is "less than" its amount.
struct PaperRow {
  std::string_view model;
  int triangles, parameters, baseLines, clustered, clusters;
  double preprocessMs, cpuMs, gpuMs;
};
constexpr std::array<PaperRow, 7> kPaper{{{"single-tree", 5610, 6, 15, 0, 0, -1, -1, -1},
                                          {"helix-house", 1495, 13, 210, 80, 22, -1, 11, 3.5},
                                          {"lever", 1178, 7, 45, 36, 10, -1, 3, 1.4},
                                          {"boat", 58214, 23, 37, 36, 24, 2, 364, 3},
                                          {"omni-tree", 29767, 18, 75, 0, 0, -1, 1, 2},
                                          {"parthenon", 132263, 10, 266, 240, 32, 2, 1122, 3},
                                          {"candler", 45366, 6, 2260, 2260, 47, 87, 719, 4}}};

struct Column {
  std::string_view title;
  std::optional<double> BenchTimes::*time;
  std::string_view key;
};
constexpr std::array<Column, 7> kColumns{{{"preprocess", &BenchTimes::preprocess, "preprocessMs"},
                                          {"placer", &BenchTimes::placer, "placerMs"},
                                          {"CPU fields", &BenchTimes::cpuFields, "cpuFieldsMs"},
                                          {"GPU fields", &BenchTimes::gpuFields, "gpuFieldsMs"},
                                          {"visibility", &BenchTimes::visibility, "visibilityMs"},
                                          {"rebuild", &BenchTimes::rebuild, "rebuildMs"},
                                          {"straightforw.", &BenchTimes::straightforward, "straightforwardMs"}}};

std::string msText(double ms) { return formatFixed(ms, ms < 1 ? 3 : ms < 100 ? 2 : 0); }

std::string paperText(double ms) {
  return ms < 0 ? "<" + formatFixed(-ms, 0) : formatFixed(ms, ms == static_cast<int>(ms) ? 0 : 1);
}

std::string timesText(const std::optional<Steady>& time) {
  return time ? msText(time->ms) + " ±" + formatFixed(100 * time->noise, 0) + "%" : "-";
}

/// Right-aligned by what is seen: the sign ± is two bytes.
void cell(std::ostream& out, const std::string& text, int width) {
  const auto seen = static_cast<int>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
  out << std::string(static_cast<std::size_t>(std::max(1, width - seen)), ' ') << text;
}

std::string ratioText(const std::optional<Steady>& straightforward, const std::optional<Steady>& placer,
                      const std::optional<Steady>& fields) {
  if (!straightforward || !placer || !fields) return "-";
  return formatFixed(straightforward->ms / std::max(placer->ms + fields->ms, 1e-9), 1) + "x";
}

void printPaper(const PaperRow& paper, std::ostream& out) {
  out << std::left << std::setw(kNameWidth) << "  the paper" << std::right;
  for (const int count : {paper.triangles, paper.parameters, paper.baseLines, paper.clustered, paper.clusters})
    cell(out, std::to_string(count), kCountWidth);
  cell(out, paperText(paper.preprocessMs), kTimeWidth);
  cell(out, paperText(paper.gpuMs), kTimeWidth);
  for (int i = 0; i < 4; ++i) cell(out, "-", kTimeWidth);
  cell(out, paperText(paper.cpuMs), kTimeWidth);
  cell(out, paper.cpuMs > 0 && paper.gpuMs > 0 ? formatFixed(paper.cpuMs / paper.gpuMs, 1) + "x" : "-", kCountWidth);
  out << "\n";
}

void printRow(const BenchResult& result, std::ostream& out) {
  const ModelStatistics& size = result.statistics;
  out << std::left << std::setw(kNameWidth) << result.model << std::right;
  for (const std::size_t count :
       {size.triangles, result.parameters, size.baseLines, size.clusteredBaseLines, size.clusters}) {
    cell(out, std::to_string(count), kCountWidth);
  }
  for (const Column& column : kColumns) cell(out, timesText(steady(result, column.time)), kTimeWidth);
  cell(out,
       ratioText(steady(result, &BenchTimes::straightforward), steady(result, &BenchTimes::placer),
                 steady(result, &BenchTimes::cpuFields)),
       kCountWidth);
  out << "\n";
}

BenchResult grown(ModelDefinition definition, BenchPlan plan) {
  const auto model = makeModel(std::move(definition));
  plan.straightforward = false;
  return *benchModel(*model, plan);
}

void printGrownHeader(std::initializer_list<const char*> titles, std::ostream& out) {
  for (const char* title : titles) cell(out, title, title == *titles.begin() ? kNameWidth : kTimeWidth + 3);
  out << "\n";
}

void printGrownRow(std::size_t count, const BenchResult& result,
                   std::initializer_list<std::optional<double> BenchTimes::*> times, std::ostream& out) {
  cell(out, std::to_string(count), kNameWidth);
  for (const auto time : times) cell(out, timesText(steady(result, time)), kTimeWidth + 3);
}

}  // namespace

void printBench(const std::vector<BenchResult>& results, std::ostream& out) {
  out << "Times in ms, one thread: medians over an orbit at an elevation of 30 degrees, 1000x1000. Each is the mean of "
         "two runs, and ± how far the\n"
         "runs are from it: the machine's noise. rebuild: after a change of the parameter that takes longest. "
         "straightforw.: every triangle is looked at\n"
         "for every candidate, on a few of the frames; ratio: that over placer + CPU fields. The paper's placer is its \"GPU impl\", which does not count the fields, its "
         "straightforw. its \"CPU impl\".\n";
  out << std::left << std::setw(kNameWidth) << "model" << std::right;
  for (const char* title : {"triangles", "params", "base lines", "clustered", "clusters"})
    cell(out, title, kCountWidth);
  for (const Column& column : kColumns) cell(out, std::string(column.title), kTimeWidth);
  cell(out, "ratio", kCountWidth);
  out << "\n";
  for (const BenchResult& result : results) {
    printRow(result, out);
    const auto paper = std::ranges::find(kPaper, result.model, &PaperRow::model);
    if (paper != kPaper.end()) printPaper(*paper, out);
  }
}

void printGrowth(std::ostream& out, const GrowthSizes& sizes) {
  out << "\nGrowth with triangles, 16 base lines (ms):\n";
  printGrownHeader({"triangles", "CPU fields", "placer", "visibility"}, out);
  for (const std::size_t triangles : sizes.triangles) {
    const int frames = triangles > 100000 ? 36 : 120;
    const BenchResult result = grown(columnField(triangles), {.frames = frames, .changes = false});
    printGrownRow(result.statistics.triangles, result,
                  {&BenchTimes::cpuFields, &BenchTimes::placer, &BenchTimes::visibility}, out);
    out << "\n" << std::flush;
  }
  out << "\nGrowth with base lines, 12 triangles (ms):\n";
  printGrownHeader({"base lines", "CPU fields", "placer, chained", "preprocess", "placer, single"}, out);
  for (const std::size_t baseLines : sizes.baseLines) {
    const int frames = baseLines > 1000 ? 24 : 120;
    const BenchResult chained = grown(windowWall(baseLines / 8, true), {.frames = frames});
    printGrownRow(chained.statistics.baseLines, chained,
                  {&BenchTimes::cpuFields, &BenchTimes::placer, &BenchTimes::preprocess}, out);
    const BenchResult single = grown(windowWall(baseLines / 8, false), {.frames = frames, .changes = false});
    cell(out, timesText(steady(single, &BenchTimes::placer)), kTimeWidth + 3);
    out << "\n" << std::flush;
  }
  out << "\nGrowth with the viewport's side in px, about 10,000 triangles, 16 base lines (ms):\n";
  printGrownHeader({"side", "CPU fields", "placer", "visibility"}, out);
  for (const std::size_t sidePx : sizes.sidesPx) {
    const BenchResult result = grown(columnField(10000), {.frames = 120, .sidePx = static_cast<double>(sidePx), .changes = false});
    printGrownRow(sidePx, result, {&BenchTimes::cpuFields, &BenchTimes::placer, &BenchTimes::visibility}, out);
    out << "\n" << std::flush;
  }
}

void writeBench(JsonWriter& json, const std::vector<BenchResult>& results) {
  json.beginArray();
  for (const BenchResult& result : results) {
    json.beginObject();
    json.key("model").value(result.model);
    json.key("triangles").value(result.statistics.triangles);
    json.key("parameters").value(result.parameters);
    json.key("baseLines").value(result.statistics.baseLines);
    json.key("clustered").value(result.statistics.clusteredBaseLines);
    json.key("clusters").value(result.statistics.clusters);
    for (const Column& column : kColumns) {
      const auto time = steady(result, column.time);
      json.key(column.key);
      time ? json.value(time->ms) : json.null();
    }
    json.endObject();
  }
  json.endArray();
}

}  // namespace dimline
