# cmake -DROOT=DIR -DOUTPUT=FILE.cpp -P: embeds the .glsl and .h files of ROOT as laver::shaderText().
file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/*.glsl ${ROOT}/*.h)
list(SORT files)
set(entries "")
foreach(name IN LISTS files)
  file(READ ${ROOT}/${name} text)
  string(APPEND entries "      {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
file(WRITE ${OUTPUT}
"#include <map>
#include <string>
#include <string_view>

#include \"kernels/compose.h\"

namespace laver {

std::string_view shaderText(std::string_view path) {
  static const std::map<std::string, std::string_view, std::less<>> texts = {
${entries}  };
  const auto found = texts.find(path);
  return found == texts.end() ? std::string_view() : found->second;
}

}  // namespace laver
")
