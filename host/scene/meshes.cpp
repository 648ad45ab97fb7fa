#include "scene/meshes.h"

#include "scene/properties.h"
#include "scene/schema.h"

namespace laver {
namespace {

using xml::Draft;
using xml::Properties;
using enum PropertyType;

void buildObj(const Properties& given, std::string_view, Draft& draft) {
  // A mesh without a file name still takes its children.
  std::string name;
  if (given.has("filename")) {
    name = given.text("filename");
    if (name.empty()) given.error("filename", "filename is empty, expected an OBJ file");
  }
  draft.meshes.push_back({given.offset(), name, given.transform("toWorld"), {}, {}, {}});
}

void buildSphere(const Properties& given, std::string_view, Draft& draft) {
  const Sphere sphere{given.triple("center"), given.real("radius")};
  draft.meshes.push_back({given.offset(), "", glm::dmat4(1.0), {}, {}, sphere});
}

}  // namespace

namespace meshes {

const MeshRow obj{
    .name = "obj",
    .object = "Mesh",
    .forms = {{.type = "obj",
               .properties =
                   {{.name = "filename", .type = String, .required = true, .meaning = "OBJ file"},
                    {.name = "toWorld",
                     .type = Transform,
                     .start = glm::dmat4(1.0),
                     .meaning = "from the file's coordinates"}},
               .build = buildObj}}};

const MeshRow sphere{.name = "sphere",
                     .object = "Sphere",
                     .forms = {{.type = "sphere",
                                .properties = {{.name = "center",
                                                .type = Point,
                                                .start = Sphere{}.centre,
                                                .unit = kSceneUnits,
                                                .meaning = "in the world"},
                                               {.name = "radius",
                                                .type = Float,
                                                .start = Sphere{}.radius,
                                                .range = moreThan(0.0),
                                                .unit = kSceneUnits,
                                                .meaning = "of the sphere"}},
                                .build = buildSphere}}};

}  // namespace meshes

const Rows<MeshRow>& meshRows() {
  static const Rows<MeshRow> rows = {&meshes::obj, &meshes::sphere};
  return rows;
}

}  // namespace laver
