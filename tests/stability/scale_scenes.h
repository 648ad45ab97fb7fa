#pragma once
#include "scene/scene.h"

// Scenes whose parts differ much in size.
namespace laver::test {

/// A bumpy ball on the ground, seen from 4 away, lit by a near light.
Scene ball();
/// The ball on a rectangle of half-sizes x and z, tilted about x. It stands beside the middle,
/// since floats are finest there.
Scene onGround(double x, double z, double tilt = 0.0);
/// The ball with one triangle, whose size is a tenth of its distance.
Scene withStray(glm::dvec3 place);
/// The ball on a sphere, and on a mesh of a sphere.
Scene onSphere(double radius);
Scene onPlanet(double radius);
/// The ball or a sphere in its place from 7 k away, with a focal length k times as long.
Scene seenFromAfar(double k, bool sphere);

}  // namespace laver::test
