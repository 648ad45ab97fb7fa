#include <iostream>

#include "commands/commands.h"
#include "commands/process.h"
#include "scene/schema_text.h"

namespace laver {

ExitCode run(const SchemaCommand& command) {
  std::cout << (command.json       ? schemaJson().dump(2) + '\n'
                : command.markdown ? schemaMarkdown()
                                   : schemaText());
  flushStandardOutput();
  return ExitCode::Ok;
}

}  // namespace laver
