// SPDX-License-Identifier: Apache-2.0
#include "experiment/compare/summary.h"

namespace jaywalk {

void SummaryMaker::add(const TestResult& test) {
  if (!counted_) {
    ++counts_.tests;
    if (test.errored) ++counts_.errored;
    if (test.succeeded && !test.errored) ++counts_.successes;
  }
  if (test.errored) return;
  if (test.succeeded) {
    score_.add(test.score);
    ticks_success_.add(test.ticks);
  }
  ticks_all_.add(test.ticks);
  cpu_us_.add(test.cpu_us);
  wall_us_.add(test.wall_us);
}

void SummaryMaker::end_pass() {
  counted_ = true;
  for (SampleMaker* each : {&score_, &ticks_success_, &ticks_all_, &cpu_us_, &wall_us_}) {
    each->end_pass();
  }
}

Summary SummaryMaker::summary() const {
  Summary summary = counts_;
  summary.score = score_.sample();
  summary.ticks_success = ticks_success_.sample();
  summary.ticks_all = ticks_all_.sample();
  summary.cpu_us = cpu_us_.sample();
  summary.wall_us = wall_us_.sample();
  return summary;
}

Summary summarise(std::span<const TestResult> tests) {
  SummaryMaker maker;
  for (int pass = 0; pass < SummaryMaker::kPasses; ++pass) {
    for (const TestResult& test : tests) maker.add(test);
    maker.end_pass();
  }
  return maker.summary();
}

}  // namespace jaywalk
