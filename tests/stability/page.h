#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace laver::test {

/// One HTML page that needs no other file: the table, the tables of bounds, the pictures.
std::string page(const nlohmann::json& cases);

/// A figure as the tables show it.
std::string figure(const nlohmann::json& value);

}  // namespace laver::test
