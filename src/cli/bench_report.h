#pragma once

#include <iosfwd>
#include <vector>

#include "app/json_writer.h"
#include "cli/bench_measure.h"

namespace dimline {

/// The models' times as a table; under a model that the paper has too, the paper's own figures (its table 1), as
/// measured there and then.
void printBench(const std::vector<BenchResult>& results, std::ostream& out);

/// How placer and fields grow: with the number of triangles (10^3 to 10^6, the same few lines), with the number of base
/// lines (10 to 10^5, the same few triangles), chained and not, and with the viewport (250 to 4000 px a side, the same
/// model). Measures as it prints.
struct GrowthSizes {
  std::vector<std::size_t> triangles{1000, 10000, 100000, 1000000};
  std::vector<std::size_t> baseLines{16, 104, 1000, 10000, 100000};
  std::vector<std::size_t> sidesPx{250, 500, 1000, 2000, 4000};
};
void printGrowth(std::ostream& out, const GrowthSizes& sizes = {});

/// A list of objects, one a model; times in ms.
void writeBench(JsonWriter& json, const std::vector<BenchResult>& results);

}  // namespace dimline
