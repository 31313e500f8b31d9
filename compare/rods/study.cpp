#include "compare/rods/study.hpp"

#include <cmath>

#include "compare/study/errors.hpp"
#include "compare/study/nan.hpp"
#include "compare/study/stopping.hpp"
#include "compare/study/tabulate.hpp"
#include "dem/model/errors.hpp"
#include "reference/errors.hpp"

namespace fiberchain::compare {
namespace {

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) throw dem::NoConvergence("chain and rod have different numbers of limit points");
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

double expected_order(const RodCase& asked) {
  const RodBenchmark& one = rod_benchmark(asked.benchmark);
  return asked.setting.bond == dem::BondModel::paper ? one.order_paper : one.order_corrected;
}

RodPoint unknown(const RodCase& asked, std::string status) {
  return {asked, nan, nan, nan, nan, nan, expected_order(asked), std::move(status)};
}

RodPoint rod_point(const RodCase& asked) {
  const RodBenchmark& one = rod_benchmark(asked.benchmark);
  try {
    const std::vector<double> chain = one.chain(asked.setting), rod = one.rod(asked.setting);
    RodSetting doubled = asked.setting;
    doubled.bonds *= 2;
    const double coarse = distance(chain, rod), fine = rod_error(one, doubled);
    return {asked, chain.at(one.shown),      rod.at(one.shown),     coarse,
            fine,  std::log2(coarse / fine), expected_order(asked), "converged"};
  } catch (const dem::NoConvergence& error) {
    return unknown(asked, error.what());
  } catch (const reference::NoConvergence& error) {
    return unknown(asked, error.what());
  }
}

dem::NamedRow rods_row(const RodPoint& p) {
  const RodSetting& s = p.asked.setting;
  return {{"rod_benchmark", p.asked.benchmark},
          {"bond", std::string(dem::name(s.bond))},
          {"aspect_ratio", std::int64_t{s.bonds}},
          {"poisson_ratio", s.poisson_ratio},
          {"rod_load", dem::known(s.load)},
          {"rod_value", dem::known(p.value)},
          {"rod_reference", dem::known(p.reference)},
          {"rod_error", dem::known(p.error)},
          {"rod_error_doubled", dem::known(p.error_doubled)},
          {"rod_order", dem::known(p.order)},
          {"rod_order_expected", p.expected},
          {"status", p.status}};
}

}  // namespace

double rod_error(const RodBenchmark& benchmark, const RodSetting& setting) {
  return distance(benchmark.chain(setting), benchmark.rod(setting));
}

bool has_converged(const RodPoint& point) { return point.status == "converged"; }

std::vector<RodCase> cases(const RodSweep& sweep) {
  std::vector<std::string> names = sweep.benchmark;
  if (names.empty())
    for (const RodBenchmark& one : rod_benchmarks()) names.emplace_back(one.name);
  std::vector<RodCase> all;
  for (const std::string& name : names) {
    const RodBenchmark& one = rod_benchmark(name);
    for (const auto bond : sweep.bond)
      for (const double nu : sweep.poisson_ratio)
        for (const double factor : sweep.load_factor)
          for (const int bonds : sweep.aspect_ratio)
            if (bonds % one.multiple == 0)
              all.push_back({name, {bond, bonds, nu, one.load_is == "-" ? nan : factor * one.load}});
  }
  if (all.empty()) throw InputError("--aspect-ratio is not allowed: no benchmark has such numbers of bonds");
  return all;
}

std::vector<RodPoint> rod_points(const std::vector<RodCase>& cases, const RodStudyOptions& options) {
  std::vector<RodPoint> points;
  for (const RodCase& asked : cases) points.push_back(unknown(asked, std::string(not_begun)));
  options.jobs.run(cases.size(), [&](std::size_t i) {
    if (options.stopped()) return;
    points[i] = rod_point(cases[i]);
    options.advance();
  });
  return points;
}

dem::Table rods_table(const std::vector<RodPoint>& points) { return tabulate(points, rods_row); }

}  // namespace fiberchain::compare
