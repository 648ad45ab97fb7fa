#include <fmt/format.h>

#include <exception>

#include "scene/obj_data.h"
#include "scene/text_source.h"

namespace laver::obj {
namespace {

void loadInto(const std::string& file, LoadResult& result) {
  xml::FileText read = xml::readFile(file);
  if (!read.problem.empty()) {
    result.problem = std::move(read.problem);
    return;
  }
  CheckResult checked = check(read.text);
  for (const Issue& issue : checked.errors) {
    result.errors.push_back(fmt::format("{}:{}: error: {}", file, issue.line, issue.message));
  }
  for (const Issue& issue : checked.warnings) {
    result.warnings.push_back(fmt::format("{}:{}: warning: {}", file, issue.line, issue.message));
  }
  if (!result.errors.empty()) return;
  result.data = parse(read.text, checked.counts);
}

}  // namespace

LoadResult load(const std::string& file) {
  LoadResult result;
  try {
    loadInto(file, result);
  } catch (const std::bad_alloc&) {
    result.problem = "is too large for the memory";
  } catch (const std::exception& fault) {
    result.problem = fault.what();
  }
  return result;
}

}  // namespace laver::obj
