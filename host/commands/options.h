#pragma once
#include <CLI/CLI.hpp>

#include "commands/commands.h"

namespace laver {

// What follows a command's name on the command line; what is given is written to `command`, which
// must outlive the parsing.
void addRenderOptions(CLI::App& app, RenderCommand& command);
void addPlanOptions(CLI::App& app, PlanCommand& command);
void addChartOptions(CLI::App& app, ChartCommand& command);

}  // namespace laver
