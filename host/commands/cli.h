#pragma once
#include <variant>

#include "commands/commands.h"

namespace laver {

using Job = std::variant<RenderCommand, PlanCommand, CompareCommand, MergeCommand, ExplainCommand,
                         ViewCommand, ChartCommand, TestCommand, DevicesCommand, SchemaCommand,
                         HelpCommand>;

/// Parses the command line. Throws Error(Usage) with one line.
Job parse(int argc, const char* const* argv);

}  // namespace laver
