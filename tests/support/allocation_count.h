#pragma once

#include <cstddef>

namespace dimline::test {

/// How often this process has asked for memory by `operator new` so far. A test that uses this links counting operators in place of the usual ones.
std::size_t allocationCount();

}  // namespace dimline::test
