#pragma once
#include <nlohmann/json.hpp>
#include <string>

namespace laver::test {

/// A self-contained HTML page: the table, the tables of bounds, the pictures.
std::string page(const nlohmann::json& cases);

/// A number as text for the tables.
std::string figure(const nlohmann::json& value);

}  // namespace laver::test
