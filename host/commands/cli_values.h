#pragma once
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <functional>
#include <optional>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include "render/options.h"
#include "scene/layers.h"
#include "scene/rows.h"

// Options whose values are names of table rows, sizes or crops.
namespace laver {

/// The names of values of type T.
template <class T>
struct Names {
  std::function<std::optional<T>(const std::string& name)> find;
  std::string all;  ///< all names, for messages
};

template <class Row>
Names<const Row*> namesIn(const Rows<Row>& rows) {
  const auto find = [&rows](const std::string& name) {
    const Row* row = rowCalled(rows, name);
    return row == nullptr ? std::nullopt : std::optional(row);
  };
  return {find, namesOf(rows)};
}

template <class T>
CLI::Validator isOneOf(const Names<T>& names) {
  const auto check = [names](const std::string& name) {
    return names.find(name) ? std::string()
                            : fmt::format("expected {}, not \"{}\"", names.all, name);
  };
  return {check, ""};
}

/// No variable of a script that turned out to be empty.
inline CLI::Validator isNotEmpty() {
  return {[](const std::string& text) { return text.empty() ? "expected a name, not \"\"" : ""; },
          ""};
}

inline CLI::Validator hasForm(const char* pattern, const char* expected) {
  const auto check = [=](const std::string& text) {
    return std::regex_match(text, std::regex(pattern))
               ? std::string()
               : fmt::format("expected {}, not \"{}\"", expected, text);
  };
  return {check, ""};
}

/// An option whose value is one name; `meaning` ends before the list of names.
template <class T, class Take>
void addName(CLI::App& app, const std::string& option, const std::string& meaning,
             const Names<T>& names, Take take) {
  app.add_option_function<std::string>(
         option, [=](const std::string& name) { take(*names.find(name)); }, meaning + names.all)
      ->check(isOneOf(names))
      ->type_name("NAME");
}

/// An option whose value is a list of different names, separated by commas.
template <class T, class Take>
void addNames(CLI::App& app, const std::string& option, const std::string& meaning,
              const Names<T>& names, Take take) {
  const auto read = [=](const std::string& given) {
    std::vector<T> all;
    for (std::size_t start = 0; start <= given.size();) {
      const std::size_t end = std::min(given.find(',', start), given.size());
      std::string name = given.substr(start, end - start);
      start = end + 1;
      if (const std::string wrong = isOneOf(names)(name); !wrong.empty())
        throw CLI::ValidationError(option, wrong);
      const T one = *names.find(name);
      if (std::find(all.begin(), all.end(), one) != all.end())
        throw CLI::ValidationError(option, name + " is named twice");
      all.push_back(one);
    }
    take(all);
  };
  app.add_option_function<std::string>(option, read, meaning)->option_text("NAME,...");
}

inline void addSize(CLI::App& app, std::optional<glm::ivec2>& size, const std::string& meaning) {
  const auto read = [&size](const std::string& text) {
    size.emplace();
    char x = 0;
    std::istringstream(text) >> size->x >> x >> size->y;
  };
  app.add_option_function<std::string>("--size", read, meaning)
      ->check(hasForm("0*[1-9][0-9]{0,8}x0*[1-9][0-9]{0,8}", "WIDTHxHEIGHT, both above 0"))
      ->type_name("WxH");
}

inline void addCrop(CLI::App& app, std::optional<Crop>& crop) {
  const auto read = [&crop](const std::string& text) {
    Crop c{};
    char comma = 0;
    std::istringstream(text) >> c.x0 >> comma >> c.y0 >> comma >> c.x1 >> comma >> c.y1;
    crop = c;
  };
  app.add_option_function<std::string>("--crop", read,
                                       "render pixels x0 <= x < x1, y0 <= y < y1 only")
      ->check(hasForm("-?[0-9]{1,9}(,-?[0-9]{1,9}){3}", "x0,y0,x1,y1"))
      ->type_name("x0,y0,x1,y1");
}

inline void addShard(CLI::App& app, std::optional<Shard>& shard) {
  const auto read = [&shard](const std::string& text) {
    Shard s{};
    char slash = 0;
    std::istringstream(text) >> s.index >> slash >> s.count;
    if (s.index >= s.count)
      throw CLI::ValidationError("--shard",
                                 "expected I/N, I from 0 to N - 1, not \"" + text + "\"");
    shard = s;
  };
  app.add_option_function<std::string>(
         "--shard", read, "render part I of N, I from 0, which laver merge joins with the others")
      ->check(hasForm("[0-9]{1,9}/[0-9]{1,9}", "I/N, two numbers"))
      ->type_name("I/N");
}

}  // namespace laver
