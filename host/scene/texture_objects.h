#pragma once
#include <array>

#include "scene/properties.h"
#include "scene/schema.h"

namespace laver::xml {

inline constexpr std::array kChecker = {PropertyRule{"color1", PropertyType::Color, "0.9 0.9 0.9"},
                                        PropertyRule{"color2", PropertyType::Color, "0.1 0.1 0.1"},
                                        PropertyRule{"scalex", PropertyType::Float, "1"},
                                        PropertyRule{"scaley", PropertyType::Float, "1"},
                                        PropertyRule{"offsetx", PropertyType::Float, "0"},
                                        PropertyRule{"offsety", PropertyType::Float, "0"}};

inline constexpr std::array kTextmap = {PropertyRule{"filename", PropertyType::String, nullptr},
                                        PropertyRule{"color", PropertyType::Color, "1 1 1"},
                                        PropertyRule{"raw", PropertyType::Boolean, "false"},
                                        PropertyRule{"scalex", PropertyType::Float, "1"},
                                        PropertyRule{"scaley", PropertyType::Float, "1"},
                                        PropertyRule{"offsetx", PropertyType::Float, "0"},
                                        PropertyRule{"offsety", PropertyType::Float, "0"}};

inline constexpr std::array kEnvironment = {PropertyRule{"filename", PropertyType::String, ""},
                                            PropertyRule{"radiance", PropertyType::Color, "1 1 1"},
                                            PropertyRule{"scale", PropertyType::Float, "1"},
                                            PropertyRule{"raw", PropertyType::Boolean, "false"},
                                            PropertyRule{"toWorld", PropertyType::Transform, ""}};

inline constexpr std::array kConstant = {PropertyRule{"radiance", PropertyType::Color, "1 1 1"}};

void buildChecker(const Properties& given, std::string_view parent, Draft& draft);
void buildTextmap(const Properties& given, std::string_view parent, Draft& draft);
void buildEnvironment(const Properties& given, std::string_view parent, Draft& draft);
void buildEnvmap(const Properties& given, std::string_view parent, Draft& draft);
void buildConstant(const Properties& given, std::string_view parent, Draft& draft);

}  // namespace laver::xml
