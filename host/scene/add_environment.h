#pragma once
#include <string_view>

#include "scene/emitters.h"

namespace laver {

namespace xml {
class Properties;
struct Draft;
}  // namespace xml

/// Makes it the scene's background, or reports why it cannot be: there is one already, or it is in
/// a mesh and has no image. In a mesh, an image takes the place of the mesh.
void addEnvironment(const xml::Properties& given, std::string_view parent,
                    const Environment& environment, xml::Draft& draft);

}  // namespace laver
