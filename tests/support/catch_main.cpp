// Catch2's main, and a listener that writes each case's begin and end to the file that DIMLINE_CASE_LOG names. Unlike a
// report that is written at the end, the log survives a crash: the case that began and never ended is the one that crashed.

#define CATCH_CONFIG_MAIN
#include <catch2/catch.hpp>

#include <cstdlib>
#include <fstream>

namespace {

struct CaseLog : Catch::TestEventListenerBase {
  using TestEventListenerBase::TestEventListenerBase;

  void testCaseStarting(const Catch::TestCaseInfo& info) override {
    if (!file_.is_open()) {
      if (const char* path = std::getenv("DIMLINE_CASE_LOG")) file_.open(path, std::ios::app);
    }
    file_ << "begin " << info.name << std::endl;
  }

  void testCaseEnded(const Catch::TestCaseStats& stats) override {
    file_ << (stats.totals.assertions.allPassed() ? "pass" : "fail") << std::endl;
  }

 private:
  std::ofstream file_;
};

}  // namespace

CATCH_REGISTER_LISTENER(CaseLog)
