#include "image/compare.h"

#include <algorithm>
#include <iostream>

#include "commands/commands.h"
#include "image/compare_report.h"
#include "image/io.h"

namespace laver {
namespace {

double valueOf(const ChannelDifference& d, const std::string& metric) {
  if (metric == "rmse") return d.rmse;
  if (metric == "relmse") return d.relativeMse;
  if (metric == "p999") return d.percentile999;
  return d.maximum;
}

}  // namespace

ExitCode run(const CompareCommand& command) {
  const auto differences = compare(readExr(command.a), readExr(command.b), command.tolerance);
  std::cout << describe(differences, command.tolerance);
  if (!std::cout.flush()) throw Error(ExitCode::Output, "standard output cannot be written");
  if (!command.judged) return ExitCode::Ok;
  // Written so that NaN is beyond any tolerance.
  const bool within = std::all_of(differences.begin(), differences.end(), [&](const auto& d) {
    return valueOf(d, command.metric) <= command.tolerance;
  });
  return within ? ExitCode::Ok : ExitCode::Different;
}

}  // namespace laver
