#pragma once
#include <vector>

#include "scene/properties.h"
#include "scene/schema.h"

namespace laver::xml {

extern const std::vector<PropertyRow> kChecker, kTextmap, kEnvironment, kConstant;

void buildChecker(const Properties& given, std::string_view parent, Draft& draft);
void buildTextmap(const Properties& given, std::string_view parent, Draft& draft);
void buildEnvironment(const Properties& given, std::string_view parent, Draft& draft);
void buildEnvmap(const Properties& given, std::string_view parent, Draft& draft);
void buildConstant(const Properties& given, std::string_view parent, Draft& draft);

}  // namespace laver::xml
