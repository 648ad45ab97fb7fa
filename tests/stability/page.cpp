#include "stability/page.h"

#include <fmt/format.h>

#include <cmath>

namespace laver::test {
namespace {

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '<')
      result += "&lt;";
    else if (c == '&')
      result += "&amp;";
    else
      result += c;
  }
  return result;
}

constexpr const char* kHead = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>laver: stability suite</title>
<style>
body { font: 15px/1.45 system-ui, sans-serif; max-width: 72rem; margin: 2rem auto; padding: 0 1rem }
table { border-collapse: collapse; margin: 1rem 0 }
th, td { padding: .2rem .7rem; border-bottom: 1px solid #ccc; text-align: right }
th:first-child, td:first-child, td.text, th.text { text-align: left }
.failed { background: #fbb }
figure { display: inline-block; margin: .5rem 1.5rem .5rem 0 }
img { image-rendering: pixelated; width: 288px; display: block; border: 1px solid #888 }
</style></head><body>
<h1>Stability suite</h1>
<p>Each case runs a usual method and laver's on the same input, against a truth of higher precision.
It fails if laver exceeds what is wanted, and also if the usual method does not fail.</p>
<table><tr><th>case</th><th class="text">input</th><th class="text">text that ran</th><th>rays</th>
<th>naive</th><th>ours</th><th>wanted</th><th class="text">unit</th><th>seconds</th></tr>
)";

}  // namespace

std::string figure(const nlohmann::json& value) {
  if (!value.is_number()) return "-";
  const auto number = value.get<double>();
  return number == std::floor(number) && std::abs(number) < 1e15 ? fmt::format("{:.0f}", number)
                                                                 : fmt::format("{:.3g}", number);
}

std::string page(const nlohmann::json& cases) {
  std::string html = kHead;
  for (const auto& c : cases)
    for (const auto& row : c["rows"])
      html += fmt::format(
          "<tr{}><td>{}: {}</td><td class=\"text\">{}</td><td class=\"text\">{}</td><td>{}</td>"
          "<td>{}</td><td>{}</td><td>{}</td><td class=\"text\">{}</td><td>{:.1f}</td></tr>\n",
          row["passed"].get<bool>() ? "" : " class=\"failed\"",
          escaped(c["case"].get<std::string>()), escaped(c["title"].get<std::string>()),
          escaped(row["what"].get<std::string>()), escaped(row["subject"].get<std::string>()),
          figure(row["rays"]), figure(row["naive"]), figure(row["ours"]), figure(row["wanted"]),
          escaped(row["unit"].get<std::string>()), row["seconds"].get<double>());
  html += "</table>\n";
  for (const auto& c : cases)
    for (const auto& table : c["tables"]) {
      html += fmt::format("<h2>{}</h2>\n<table>", escaped(table["caption"].get<std::string>()));
      bool head = true;
      for (const auto& line : table["cells"]) {
        html += "<tr>";
        for (const auto& cell : line)
          html +=
              fmt::format("<{0}>{1}</{0}>", head ? "th" : "td", escaped(cell.get<std::string>()));
        html += "</tr>\n";
        head = false;
      }
      html += "</table>\n";
    }
  for (const auto& c : cases)
    for (const auto& picture : c["pictures"])
      html += fmt::format(
          "<h2>{}: {}</h2>\n<p>{}</p>\n"
          "<figure><img alt=\"the usual method\" src=\"{}\"><figcaption>the usual "
          "method</figcaption></figure>\n"
          "<figure><img alt=\"laver\" src=\"{}\"><figcaption>laver</figcaption></figure>\n",
          escaped(c["case"].get<std::string>()), escaped(c["title"].get<std::string>()),
          escaped(picture["caption"].get<std::string>()), picture["naive"].get<std::string>(),
          picture["ours"].get<std::string>());
  return html + "</body></html>\n";
}

}  // namespace laver::test
