#include "lab/suite/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <sstream>

namespace laver::suite {
namespace {

/// The first line of a reason, and how many more follow.
std::string firstLine(const std::string& reason) {
  const auto further = std::count(reason.begin(), reason.end(), '\n');
  const std::string first = reason.substr(0, reason.find('\n'));
  return further == 0 ? first : fmt::format("{} (and {} more)", first, further);
}

std::string inSeconds(double seconds) { return fmt::format("{:.3f}", seconds); }

void addCounts(pugi::xml_node node, const Counts& counts) {
  node.append_attribute("tests") = counts.passed + counts.failed + counts.skipped;
  node.append_attribute("failures") = counts.failed;
  node.append_attribute("errors") = 0;
  node.append_attribute("skipped") = counts.skipped;
  node.append_attribute("time") = inSeconds(counts.seconds).c_str();
}

/// The class of a test is its folder, so that viewers of JUnit files group by folder.
void addCase(pugi::xml_node suite, const Result& result, const std::string& folder) {
  const std::string name = printable(result.name);
  const std::size_t slash = name.rfind('/');
  pugi::xml_node node = suite.append_child("testcase");
  node.append_attribute("classname") =
      slash == std::string::npos ? folder.c_str() : name.substr(0, slash).c_str();
  node.append_attribute("name") = name.substr(slash + 1).c_str();
  node.append_attribute("time") = inSeconds(result.seconds).c_str();
  const std::string reason = printable(result.reason);
  const std::string figure = result.figure ? result.figure->text : "";
  if (result.verdict == Verdict::Skipped)
    node.append_child("skipped").append_attribute("message") = reason.c_str();
  if (result.verdict == Verdict::Failed) {
    pugi::xml_node failure = node.append_child("failure");
    const std::string message = figure + (figure.empty() ? "" : ": ") + firstLine(reason);
    failure.append_attribute("message") = message.c_str();
    failure.text() = reason.c_str();
  }
  std::string output = figure + (figure.empty() ? "" : "\n") + printable(result.output);
  if (!result.change.empty()) output += "expected picture: " + printable(result.change) + "\n";
  if (!output.empty()) node.append_child("system-out").text() = output.c_str();
}

}  // namespace

Counts countsOf(const std::vector<Result>& results) {
  Counts counts;
  for (const Result& result : results) {
    counts.seconds += result.seconds;
    if (result.verdict == Verdict::Passed) ++counts.passed;
    if (result.verdict == Verdict::Failed) ++counts.failed;
    if (result.verdict == Verdict::Skipped) ++counts.skipped;
  }
  return counts;
}

std::string nameOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::Passed:
      return "passed";
    case Verdict::Failed:
      return "failed";
    case Verdict::Skipped:
      return "skipped";
  }
  return {};
}

std::string printable(const std::string& text) {
  using nlohmann::json;
  const std::string utf8 = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
  std::string all = json::parse(utf8).get<std::string>();
  std::ranges::replace_if(
      all, [](unsigned char c) { return (c < 0x20 && c != '\n' && c != '\t') || c == 0x7f; }, ' ');
  return all;
}

std::string lineOf(const Result& result) {
  std::string line =
      fmt::format("{:<7}  {}  {:.2f} s", nameOf(result.verdict), result.name, result.seconds);
  if (result.figure) line += "  " + result.figure->text;
  if (!result.change.empty()) line.append("  ").append(firstLine(result.change));
  if (!result.reason.empty()) line.append(": ").append(firstLine(result.reason));
  std::string whole = printable(line);
  std::ranges::replace(whole, '\n', ' ');
  return whole;
}

std::string summaryOf(const Counts& counts) {
  return fmt::format("{} passed, {} failed, {} skipped", counts.passed, counts.failed,
                     counts.skipped);
}

std::string junitOf(const std::vector<Result>& results, const std::string& folder) {
  const std::string name = printable(folder);
  pugi::xml_document document;
  pugi::xml_node suites = document.append_child("testsuites");
  suites.append_attribute("name") = "laver";
  addCounts(suites, countsOf(results));
  pugi::xml_node suite = suites.append_child("testsuite");
  suite.append_attribute("name") = name.c_str();
  addCounts(suite, countsOf(results));
  for (const Result& result : results) addCase(suite, result, name);
  std::ostringstream out;
  document.save(out, "  ", pugi::format_indent, pugi::encoding_utf8);
  return out.str();
}

}  // namespace laver::suite
