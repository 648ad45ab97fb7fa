#pragma once
#include <cstdint>
#include <string>

#include "render/reasons.h"

// Reasons for what a kernel holds of a scene; render/reasons.cpp has those for how it is sampled.
namespace laver {

/// Numbers and flags from which the reasons are made.
struct Facts {
  Facts(const Scene& s, const RenderOptions& o, const Choices& c)
      : scene(s), options(o), choices(c), uploads(c.uploads), first(c.pictures.front().key) {
    primitives = primitivesOf(s);
    for (const Mesh& mesh : s.meshes) {
      spheres += mesh.sphere ? 1 : 0;
      normals += mesh.normals.size();
      lamps += mesh.light ? 1 : 0;
      uvs += mesh.uvs.size();
    }
    for (const PictureChoice& picture : c.pictures) {
      const TraceKey& key = picture.key;
      hasSpheres |= key.spheres;
      slivers |= key.slivers;
      followsPaths |= picture.integrator.row->needs.emitters;
      coloured |= !key.bsdfs.empty() && (key.lights || key.background == "none" || followsPaths);
      byteImages |= key.byteImages;
      floatImages |= key.floatImages;
      if (key.background != "none") background = key.background;
      lit |= key.lights;
    }
  }

  bool traced() const { return uploads.primitives; }
  std::string shownBy() const {
    return std::string(scene.integrator.row->name) +
           (choices.pictures.size() > 1 ? " and its layers" : "");
  }
  /// Bytes of the attributes of all triangles in a format, without the arrays to which they refer.
  std::uint64_t attributeBytes(bool withNormals, std::uint32_t indexBytes) const {
    return primitives * indexBytes * (withNormals ? 4 : 1);
  }
  std::uint64_t attributeBytes() const {
    return uploads.attributes ? attributeBytes(uploads.normals, uploads.indexBytes) : 0;
  }

  const Scene& scene;
  const RenderOptions& options;
  const Choices& choices;
  const Uploads& uploads;
  const TraceKey& first;
  std::uint64_t primitives = 0, spheres = 0, normals = 0, uvs = 0, lamps = 0;
  bool hasSpheres = false, slivers = false, coloured = false, lit = false, byteImages = false,
       floatImages = false;
  bool followsPaths = false;  ///< light comes from all emitters
  std::string background = "none";
};

Reason raysReason(const Facts& f);
Reason coordinatesReason(const Facts& f);
Reason spheresReason(const Facts& f);
Reason planesReason(const Facts& f);
Reason normalsReason(const Facts& f);
Reason materialsReason(const Facts& f);
Reason materialBsdfsReason(const Facts& f);
Reason surfaceTexturesReason(const Facts& f);
Reason imagesReason(const Facts& f);
Reason backgroundReason(const Facts& f);
Reason uvsReason(const Facts& f);
Reason indicesReason(const Facts& f);
Reason lightsReason(const Facts& f);
Reason shadowRaysReason(const Facts& f);

}  // namespace laver
