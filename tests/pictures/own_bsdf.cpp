// BSDFs from users' files.
#include "image/io.h"
#include "pictures/command_line.h"

namespace laver::test {
namespace {

// A copy of the diffuse BSDF, times a number.
constexpr const char* kScaled =
    "vec3 mineEval(Material m, vec3 normal, vec3 wi, vec3 wo, vec3 light) {\n"
    "  const bool above = dotProduct(normal, wi) > 0.0 && dotProduct(normal, wo) > 0.0;\n"
    "  return above ? light * m.albedo * 0.31830989 * xml_scale : vec3(0.0);\n"
    "}\n"
    "float minePdf(Material m, vec3 normal, vec3 wi, vec3 wo) { return 0.0; }\n"
    "vec3 mineSample(Material m, vec3 normal, vec3 wi, vec2 numbers, out vec3 wo) {\n"
    "  wo = normal;\n"
    "  return vec3(0.0);\n"
    "}\n";

class OwnBsdf : public CommandLine {
 protected:
  OwnBsdf() {
    write("t.obj", "v -9 -9 3\nv 9 -9 3\nv 0 9 3\nf 1 3 2\n");
    write("u.obj", "v -9 -9 4\nv 9 -9 4\nv 0 9 4\nf 1 3 2\n");
  }
  static std::string mesh(const std::string& file, const std::string& bsdf) {
    return "<mesh type=\"obj\"><string name=\"filename\" value=\"" + file + "\"/>" + bsdf +
           "</mesh>";
  }
  Image render(const std::string& bsdf) {
    write("s.xml",
          "<scene><integrator type=\"direct_whitted\"/><camera type=\"perspective\">"
          "<rfilter type=\"box\"/><integer name=\"width\" value=\"8\"/>"
          "<integer name=\"height\" value=\"8\"/></camera><sampler type=\"independent\"/>"
          "<emitter type=\"pointlight\"><point name=\"position\" value=\"0 0 0\"/></emitter>" +
              mesh("t.obj", bsdf) + mesh("u.obj", "<bsdf type=\"diffuse\"/>") + "</scene>");
    outcome_ = laver("s.xml --device $device --quiet -o a.exr");
    EXPECT_EQ(outcome_.code, 0) << outcome_.err;
    return readExr((folder_ / "a.exr").string());
  }
  Outcome outcome_;
};

TEST_F(OwnBsdf, EqualsTheBuiltInBsdfThatItCopies) {
  write("mine.glsl", kScaled);
  const char* const color = "<color name=\"albedo\" value=\"0.5 0.25 0.125\"/>";
  const Image own = render(std::string("<bsdf type=\"mine\">") + color +
                           "<float name=\"scale\" value=\"1\"/></bsdf>");
  const Image twice = render(std::string("<bsdf type=\"mine\">") + color +
                             "<float name=\"scale\" value=\"2\"/></bsdf>");
  const Image laversOwn = render(std::string("<bsdf type=\"diffuse\">") + color + "</bsdf>");
  EXPECT_GT(laversOwn.at(4, 4, 0), 0.0F);
  ASSERT_EQ(own.pixels.size(), laversOwn.pixels.size());
  for (std::size_t i = 0; i < own.pixels.size(); ++i) {
    // Three products of another order round by at most 3 ulp more; EXPECT_FLOAT_EQ allows 4.
    EXPECT_FLOAT_EQ(own.pixels[i], laversOwn.pixels[i]);
    EXPECT_EQ(twice.pixels[i], 2.0F * own.pixels[i]);
  }
}

TEST_F(OwnBsdf, AnErrorNamesItsFileAndLine) {
  write("mine.glsl", std::string(kScaled) + "vec3 nonsense() { return neverDeclared; }\n");
  write("s.xml",
        "<scene><integrator type=\"direct_whitted\"/>" +
            mesh("t.obj", "<bsdf type=\"mine\"><float name=\"scale\" value=\"1\"/></bsdf>") +
            "<emitter type=\"pointlight\"/></scene>");
  const Outcome run = laver("s.xml --device $device --quiet -o a.exr");
  EXPECT_EQ(run.code, 3);
  EXPECT_EQ(run.err.find("mine.glsl:10: error: "), 0U) << run.err;
}

}  // namespace
}  // namespace laver::test
