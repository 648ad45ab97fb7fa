// Every error of a scene file, with the exact message.
#include "scene/schema.h"
#include "scene/suggest.h"
#include "support/scene_files.h"

namespace laver::test {
namespace {

struct Case {
  const char* name;
  std::string xml;
  std::string error;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class SceneErrors : public testing::TestWithParam<Case> {
 protected:
  SceneFiles files_;
};

TEST_P(SceneErrors, StatePositionAndExpectation) {
  files_.write("t.obj", kTriangle);
  EXPECT_EQ(files_.errors(GetParam().xml), GetParam().error);
}

std::string camera(const std::string& inside) {
  return scene("<camera type=\"perspective\">" + inside + "</camera>");
}
std::string transform(const std::string& inside) {
  return camera("<transform name=\"toWorld\">" + inside + "</transform>");
}
std::string number(const std::string& tag, const std::string& name, const std::string& value) {
  return "<" + tag + " name=\"" + name + "\" value=\"" + value + "\"/>";
}

const std::vector<Case> kStructure = {
    {"empty_file", "", "f.xml:1:1: error: the file is empty, expected <scene>"},
    {"only_white_space", " \n\t\n", "f.xml:1:1: error: the file is empty, expected <scene>"},
    {"only_a_comment", "<!-- a -->", "f.xml:1:1: error: no tag, expected <scene>"},
    {"only_text", "hello", "f.xml:1:1: error: text outside of tags, expected <scene>"},
    {"utf16", "\xFF\xFE<", "f.xml: error: its encoding is UTF-16LE, but not at byte 2"},
    {"nul", std::string("<scene>\n \0</scene>", 18),
     "f.xml:2:2: error: a NUL byte, expected an XML text"},
    {"wrong_root", "<!-- a -->\n<test type=\"ttest\"/>",
     "f.xml:2:2: error: the root is <test>, expected <scene>"},
    {"second_root", scene("") + "\n<scene/>",
     "f.xml:4:2: error: a second root <scene>, expected one <scene>"},
    {"text_behind_the_root", scene("") + "\n  rest",
     "f.xml:4:3: error: text outside of tags, expected <scene>"},
    {"text_in_the_scene", scene("  text"), "f.xml:2:3: error: text outside of tags in <scene>"},
    {"cdata", scene("<![CDATA[x]]>"), "f.xml:2:10: error: text outside of tags in <scene>"},
    {"tags_do_not_match", "<scene>\n<camera>\n</scene>",
     "f.xml:3:3: error: bad XML: start and end tags do not match"},
    {"tag_does_not_end", "<scene>\n <camera",
     "f.xml:2:8: error: bad XML: a tag is broken, expected '>' or \"/>\""},
    {"attribute_without_quotes", "<scene>\n <camera type=a/>\n</scene>",
     "f.xml:2:15: error: bad XML: an attribute is broken, expected name=\"value\""},
    {"comment_does_not_end", "<scene>\n <!-- </scene>",
     "f.xml:2:14: error: bad XML: a comment does not end, expected \"-->\""},
    {"no_integrator", "<scene/>",
     "f.xml:1:2: error: <scene> needs an <integrator>: expected type \"normals\", "
     "\"direct_whitted\", \"depth\", \"av\", \"ao\", \"geometric_normals\", \"whitted\", "
     "\"direct\", \"direct_ems\", \"direct_mats\", \"direct_mis\", \"path_ems\", \"path_mats\", "
     "\"path_mis\", \"photonmapper\" or \"simple\""},
    {"second_integrator", scene("<integrator type=\"depth\"/>"),
     "f.xml:2:2: error: a second <integrator> in <scene>, expected one: the first is in line 1"},
    {"second_camera", scene("<camera type=\"perspective\"/>\n <camera type=\"perspective\"/>"),
     "f.xml:3:3: error: a second <camera> in <scene>, expected one: the first is in line 2"},
    {"second_sampler", scene("<sampler type=\"independent\"/><sampler type=\"independent\"/>"),
     "f.xml:2:31: error: a second <sampler> in <scene>, expected one: the first is in line 2"},
    {"second_rfilter", camera("<rfilter type=\"box\"/>\n<rfilter type=\"box\"/>"),
     "f.xml:3:2: error: a second <rfilter> in <camera>, expected one: the first is in line 2"},
    {"second_bsdf", scene(mesh("<bsdf type=\"diffuse\"/>\n<bsdf type=\"diffuse\"/>")),
     "f.xml:3:2: error: a second <bsdf> in <mesh>, expected one: the first is in line 2"},
    {"second_light_of_a_mesh",
     scene(mesh("<emitter type=\"pointlight\"/>\n<emitter type=\"pointlight\"/>")),
     "f.xml:3:2: error: a second <emitter> in <mesh>, expected one: the first is in line 2"},
    {"property_in_a_property", camera("<float name=\"fov\" value=\"3\">\n<float/></float>"),
     "f.xml:3:2: error: <float> inside <float>, expected nothing there"},
    {"text_in_a_property", camera("<float name=\"fov\" value=\"3\">3</float>"),
     "f.xml:2:56: error: text inside <float>, expected nothing there"},
    {"operation_outside_of_a_transform", scene(mesh("\n<scale value=\"1 1 1\"/>")),
     "f.xml:3:2: error: <scale> outside of a <transform>"},
    {"bsdf_in_the_scene", scene("<bsdf type=\"diffuse\"/>"),
     "f.xml:2:2: error: <bsdf> is in <scene>, expected in <mesh>"},
    {"rfilter_in_the_scene", scene("<rfilter type=\"box\"/>"),
     "f.xml:2:2: error: <rfilter> is in <scene>, expected in <camera>"},
    {"mesh_in_a_mesh", scene(mesh("\n" + mesh())),
     "f.xml:3:2: error: <mesh> is in <mesh>, expected in <scene>"},
    {"object_without_type", scene("<camera/>"),
     "f.xml:2:2: error: <camera> needs the attribute \"type\""},
    {"property_without_name", camera("<float value=\"3\"/>"),
     "f.xml:2:29: error: <float> needs the attribute \"name\""},
    {"property_without_value", camera("<float name=\"fov\"/>"),
     "f.xml:2:29: error: <float> needs the attribute \"value\""},
    {"property_without_both", camera("<float/>"),
     "f.xml:2:29: error: <float> needs the attribute \"name\"\n"
     "f.xml:2:29: error: <float> needs the attribute \"value\""},
    {"misspelt_property_tag", camera("<flaot name=\"fov\" value=\"3\"/>"),
     "f.xml:2:29: error: unknown tag <flaot>: the nearest is <float>"},
    {"misspelt_mesh_tag", scene("<mseh type=\"obj\"/>"),
     "f.xml:2:2: error: unknown tag <mseh>: the nearest is <mesh>"},
};

const std::vector<Case> kValues = {
    {"not_a_number", camera(number("float", "fov", "abc")),
     "f.xml:2:29: error: the property \"fov\": \"abc\" is not a number, expected a number"},
    {"trailing_garbage", camera(number("float", "fov", "30 deg")),
     "f.xml:2:29: error: the property \"fov\": \"30 deg\" is not a number, expected a number"},
    {"empty_number", camera(number("float", "fov", "")),
     "f.xml:2:29: error: the property \"fov\": \"\" is not a number, expected a number"},
    {"nan", camera(number("float", "fov", "nan")),
     "f.xml:2:29: error: the property \"fov\": \"nan\" is not a finite number, expected a number"},
    {"overflow", camera(number("float", "fov", "1e999")),
     "f.xml:2:29: error: the property \"fov\": \"1e999\" is too large for a number, expected a "
     "number"},
    {"integer_with_a_point", camera(number("integer", "width", "3.5")),
     "f.xml:2:29: error: the property \"width\": \"3.5\" is not an integer, expected an integer"},
    {"integer_overflow", camera(number("integer", "width", "99999999999999999999")),
     "f.xml:2:29: error: the property \"width\": \"99999999999999999999\" is too large for an "
     "integer, expected an integer"},
    {"float_for_an_integer", camera(number("float", "width", "3")),
     "f.xml:2:29: error: the property \"width\" is a <float>, expected a <integer>"},
    {"color_for_a_float", camera(number("color", "fov", "1 1 1")),
     "f.xml:2:29: error: the property \"fov\" is a <color>, expected a <float>"},
    {"value_for_a_transform", camera(number("string", "toWorld", "x")),
     "f.xml:2:29: error: the property \"toWorld\" is a <string>, expected a <transform>"},
    {"two_numbers_for_a_color",
     scene(mesh("\n<bsdf type=\"diffuse\"><color name=\"albedo\" value=\"1, 2\"/></bsdf>")),
     "f.xml:3:23: error: the property \"albedo\": expected 3 numbers, found 2 in \"1, 2\""},
    {"four_numbers_for_a_point",
     scene("<emitter type=\"pointlight\"><point name=\"position\" value=\"1 2 3 4\"/></emitter>"),
     "f.xml:2:29: error: the property \"position\": expected 3 numbers, found 4 in \"1 2 3 4\""},
    {"garbage_in_a_triple",
     scene("<emitter type=\"pointlight\"><point name=\"position\" value=\"1 2 3f\"/></emitter>"),
     "f.xml:2:29: error: the property \"position\": \"3f\" is not a number, expected 3 numbers"},
    {"film_of_no_width", camera(number("integer", "width", "0")),
     "f.xml:2:29: error: width must be 1 to 2147483647 pixels, found 0"},
    {"film_of_negative_height", camera(number("integer", "height", "-5")),
     "f.xml:2:29: error: height must be 1 to 2147483647 pixels, found -5"},
    {"film_of_too_many_pixels",
     camera(number("integer", "height", "65536") + number("integer", "width", "65536")),
     "f.xml:2:67: error: a film of 65536x65536 has more than 2147483647 pixels"},
    {"no_field_of_view", camera(number("float", "fov", "0")),
     "f.xml:2:29: error: fov must be more than 0 and less than 180 degrees, found 0"},
    {"field_of_view_too_wide", camera(number("float", "fov", "180")),
     "f.xml:2:29: error: fov must be more than 0 and less than 180 degrees, found 180"},
    {"near_plane_at_zero", camera(number("float", "nearClip", "0")),
     "f.xml:2:29: error: nearClip must be more than 0, found 0"},
    {"far_plane_before_the_near_one",
     camera(number("float", "nearClip", "2") + number("float", "farClip", "2")),
     "f.xml:2:63: error: farClip must be more than nearClip (2), found 2"},
    {"default_far_plane_before_the_near_one", camera(number("float", "nearClip", "20000")),
     "f.xml:2:2: error: farClip must be more than nearClip (20000), found 10000"},
    {"no_samples",
     scene("<sampler type=\"independent\">" + number("integer", "sampleCount", "0") + "</sampler>"),
     "f.xml:2:30: error: sampleCount must be 1 to 4294967295, found 0"},
    {"filter_without_radius",
     camera("\n<rfilter type=\"gaussian\">" + number("float", "radius", "0") + "</rfilter>"),
     "f.xml:3:27: error: radius must be more than 0, found 0"},
    {"filter_without_width",
     camera("\n<rfilter type=\"gaussian\">" + number("float", "stddev", "-1") + "</rfilter>"),
     "f.xml:3:27: error: stddev must be more than 0, found -1"},
    {"no_power", scene("<emitter type=\"point\"/>"),
     "f.xml:2:2: error: emitter \"point\" needs the property <color name=\"power\">"},
    {"no_file_name", scene("<mesh type=\"obj\"/>"),
     "f.xml:2:2: error: mesh \"obj\" needs the property <string name=\"filename\">"},
    {"empty_file_name", scene("<mesh type=\"obj\">" + number("string", "filename", "") + "</mesh>"),
     "f.xml:2:19: error: filename is empty, expected an OBJ file"},
    {"missing_file",
     scene("<mesh type=\"obj\">" + number("string", "filename", "n.obj") + "</mesh>"),
     "f.xml:2:2: error: mesh file \"n.obj\" not found, expected next to the scene or in the "
     "working directory"},
    {"folder_for_a_file",
     scene("<mesh type=\"obj\">" + number("string", "filename", ".") + "</mesh>"),
     "f.xml:2:2: error: mesh file \".\": is a folder, expected a file"},
    {"device_for_a_file",
     scene("<mesh type=\"obj\">" + number("string", "filename", "/dev/zero") + "</mesh>"),
     "f.xml:2:2: error: mesh file \"/dev/zero\": is a device, expected a file"},
};

const std::vector<Case> kTransforms = {
    {"text", transform("a"), "f.xml:2:54: error: text outside of tags in <transform>"},
    {"misspelt", transform("<lookAt/>"),
     "f.xml:2:55: error: <lookAt> is not an operation of a transform: expected \"translate\", "
     "\"scale\", \"rotate\", \"matrix\" or \"lookat\" (nearest: \"lookat\")"},
    {"no_value", transform("<translate/>"),
     "f.xml:2:55: error: <translate> needs the attribute \"value\""},
    {"one_number", transform("<scale value=\"2\"/>"),
     "f.xml:2:55: error: <scale> \"value\": expected 3 numbers, found 1 in \"2\""},
    {"short_matrix", transform("<matrix value=\"1 2 3\"/>"),
     "f.xml:2:55: error: <matrix> \"value\": expected 16 numbers, found 3 in \"1 2 3\""},
    {"rotate_without_angle", transform("<rotate axis=\"1 0 0\"/>"),
     "f.xml:2:55: error: <rotate> needs the attribute \"angle\""},
    {"rotate_about_nothing", transform("<rotate axis=\"0 0 0\" angle=\"3\"/>"),
     "f.xml:2:55: error: <rotate> \"axis\" is zero, expected a direction"},
    {"two_angles", transform("<rotate axis=\"0 0 1\" angle=\"3 4\"/>"),
     "f.xml:2:55: error: <rotate> \"angle\": expected 1 number, found 2 in \"3 4\""},
    {"lookat_at_itself", transform("<lookat origin=\"1 2 3\" target=\"1 2 3\" up=\"0 1 0\"/>"),
     "f.xml:2:55: error: <lookat> has no direction: expected a target off the origin and an up off "
     "the view"},
    {"up_along_the_view", transform("<lookat origin=\"0 0 0\" target=\".1 .2 .3\" up=\"1 2 3\"/>"),
     "f.xml:2:55: error: <lookat> has no direction: expected a target off the origin and an up off "
     "the view"},
    {"singular", transform("<scale value=\"1 0 1\"/>"),
     "f.xml:2:29: error: the transform \"toWorld\" is singular, expected an invertible one"},
    {"overflow", transform("<scale value=\"1e200 1 1\"/><scale value=\"1e200 1 1\"/>"),
     "f.xml:2:29: error: the transform \"toWorld\" is singular, expected an invertible one"},
    {"content", transform("<scale value=\"1 1 1\"><scale value=\"1 1 1\"/></scale>"),
     "f.xml:2:76: error: <scale> inside <scale>, expected nothing there"},
};

const std::vector<Case> kLacking = {
    {"integrator", scene("", "vol_path"),
     "f.xml:1:9: error: laver has no integrator of type \"vol_path\": expected \"normals\", "
     "\"direct_whitted\", \"depth\", \"av\", \"ao\", \"geometric_normals\", \"whitted\", "
     "\"direct\", \"direct_ems\", \"direct_mats\", \"direct_mis\", \"path_ems\", \"path_mats\", "
     "\"path_mis\", \"photonmapper\" or \"simple\"; there is no file vol_path.glsl next to the "
     "scene either"},
    {"camera", scene("<camera type=\"fisheye\"/>"),
     "f.xml:2:2: error: laver has no camera of type \"fisheye\": expected \"perspective\", "
     "\"thinlens\", \"depthoffield\" or \"dofCamera\""},
    {"sampler", scene("<sampler type=\"halton\"/>"),
     "f.xml:2:2: error: laver has no sampler of type \"halton\": expected \"independent\", "
     "\"stratified\" or \"sobol\""},
    {"rfilter", camera("\n<rfilter type=\"gausian\"/>"),
     "f.xml:3:2: error: laver has no rfilter of type \"gausian\": expected \"gaussian\", "
     "\"mitchell\", \"tent\" or \"box\" (nearest: \"gaussian\")"},
    {"cylinder", scene("<mesh type=\"cylinder\"><point name=\"p0\" value=\"0 0 0\"/></mesh>"),
     "f.xml:2:2: error: laver has no mesh of type \"cylinder\": expected \"obj\" or \"sphere\""},
    {"area_light", scene(mesh("\n<emitter type=\"area\"/>"), "direct_whitted"),
     "f.xml:3:2: error: integrator \"direct_whitted\" uses point lights only"},
    {"area_light_of_no_mesh", scene("<emitter type=\"area\"/>", "path_mis"),
     "f.xml:2:2: error: emitter \"area\" stands in <scene>, expected it in <mesh>"},
    {"sky", scene("<emitter type=\"sky\"/>", "direct_whitted"),
     "f.xml:2:2: error: laver has no emitter of type \"sky\": expected \"pointlight\", "
     "\"point\", \"spotlight\", \"spot\", \"directional\", \"area\", \"environment\", \"envmap\", "
     "\"constant\" or \"distantdisk\""},
    {"subsurface", scene(mesh("\n<subsurface type=\"dipole\"/>"), "direct_whitted"),
     "f.xml:3:2: error: unknown tag <subsurface>: expected " +
         xml::expectedNames("", xml::knownTags())},
    {"capitals", camera("<FLOAT name=\"fov\" value=\"3\"/>"),
     "f.xml:2:29: error: unknown tag <FLOAT>: the nearest is <float>"},
};

const auto kName = [](const auto& info) { return std::string(info.param.name); };
INSTANTIATE_TEST_SUITE_P(Structure, SceneErrors, testing::ValuesIn(kStructure), kName);
INSTANTIATE_TEST_SUITE_P(Values, SceneErrors, testing::ValuesIn(kValues), kName);
INSTANTIATE_TEST_SUITE_P(Transforms, SceneErrors, testing::ValuesIn(kTransforms), kName);
INSTANTIATE_TEST_SUITE_P(Lacking, SceneErrors, testing::ValuesIn(kLacking), kName);

TEST(SceneErrors, AnUnknownBsdfOrTextureNamesThoseOfTheTable) {
  const SceneFiles files;
  files.write("t.obj", kTriangle);
  EXPECT_EQ(files.errors(scene(
                mesh("<bsdf type=\"diffuse\">\n<texture name=\"albedo\" type=\"perlin\"/></bsdf>"),
                "direct_whitted")),
            "f.xml:3:2: error: laver has no texture of type \"perlin\": expected " +
                xml::expectedNames("perlin", xml::knownTypes("texture")));
  EXPECT_EQ(files.errors(scene(mesh("\n<bsdf type=\"velvet\"/>"), "direct_whitted")),
            "f.xml:3:2: error: laver has no bsdf of type \"velvet\": expected " +
                xml::expectedNames("velvet", xml::knownTypes("bsdf")) +
                "; there is no file velvet.glsl next to the scene either");
}

}  // namespace
}  // namespace laver::test
