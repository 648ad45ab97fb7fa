// Every struct, binding number and constant that crosses the border of host and device.
#ifndef LAVER_SHARED_LAYOUT_H
#define LAVER_SHARED_LAYOUT_H
#include "types.h"

LAVER_SHARED_BEGIN

// Bindings of descriptor set 0. T: texel buffer of uvec4, S: storage buffer, U: uniform buffer.
LAVER_CONST uint BIND_PARAMS = 0;      // U Params
LAVER_CONST uint BIND_NODES = 1;       // T Node
LAVER_CONST uint BIND_TRIANGLES = 2;   // T Triangle
LAVER_CONST uint BIND_ATTRIBUTES = 3;  // T Attributes, one a triangle
LAVER_CONST uint BIND_NORMALS = 4;     // T vec4, one a vertex normal
LAVER_CONST uint BIND_MATERIALS = 5;   // T Material
LAVER_CONST uint BIND_LIGHTS = 6;      // T Light
LAVER_CONST uint BIND_JUMPS = 7;       // T Jump
LAVER_CONST uint BIND_RADIANCE = 8;    // S vec4, one a sample: r, g, b, 1 or 0 where dropped
LAVER_CONST uint BIND_WEIGHTS = 9;     // S float, [axis][offset][sample]
LAVER_CONST uint BIND_FILM = 10;       // S FilmPixel
LAVER_CONST uint BIND_STATUS = 11;     // S Status
LAVER_CONST uint BIND_RADIANCE_TEXELS = 12;  // T the radiance buffer, for reading
LAVER_CONST uint BIND_WEIGHT_TEXELS = 13;    // T the weights buffer, one float a texel
LAVER_CONST uint BINDINGS = 14;

// Specialisation constants: what the scene needs (shaders/*.glsl say what each leaves out).
LAVER_CONST uint SPEC_STACK = 0;         // entries of the traversal stack
LAVER_CONST uint SPEC_NORMALS = 1;       // some mesh has vertex normals
LAVER_CONST uint SPEC_ALBEDOS = 2;       // the meshes differ in albedo
LAVER_CONST uint SPEC_LIGHTS = 3;        // the scene has lights
LAVER_CONST uint SPEC_JUMP_LEVELS = 4;   // 1 to 3 tables of the sampler are needed
LAVER_CONST uint SPEC_FILTER = 5;        // FILTER_*
LAVER_CONST uint SPEC_APRON = 6;         // pixels on each side that a sample can reach
LAVER_CONST uint SPEC_NORI_TABLE = 7;    // filter weights from Nori's table
LAVER_CONST uint SPEC_CONSTANTS = 8;

LAVER_CONST uint FILTER_GAUSSIAN = 0;
LAVER_CONST uint FILTER_MITCHELL = 1;
LAVER_CONST uint FILTER_TENT = 2;
LAVER_CONST uint FILTER_BOX = 3;

LAVER_CONST uint GATHER_GROUP_X = 32;
LAVER_CONST uint GATHER_GROUP_Y = 2;

// Lights looked at in one dispatch; more are summed in further dispatches, so that an invocation
// stays far below lavapipe's 65,535 loop iterations.
LAVER_CONST uint LIGHTS_A_DISPATCH = 8;
// Loop iterations after which an invocation gives up and raises Status.incomplete; the margin to
// 65,535 is for the loops that do not count: lights and the last turn of each loop.
LAVER_CONST uint MAX_ITERATIONS = 60000;

// A child reference: REF_NONE, a node's index, or REF_LEAF | kind << REF_KIND_SHIFT | first slot.
LAVER_CONST uint REF_NONE = 0xffffffffu;
LAVER_CONST uint REF_LEAF = 0x80000000u;
LAVER_CONST uint REF_KIND_SHIFT = 28;
LAVER_CONST uint REF_INDEX_MASK = 0x0fffffffu;
LAVER_CONST uint KIND_TRIANGLE = 0;
LAVER_CONST uint NODE_WIDTH = 8;
LAVER_CONST uint MAX_LEAF = 8;  // triangles

LAVER_CONST uint NO_HIT = 0xffffffffu;

// One child of a node: its box, already padded, and what it refers to. 2 texels.
struct Child {
  vec3 lo;
  uint ref;
  vec3 hi;
  uint count;  // primitives of a leaf, 0 for a node
};

// Slot i holds the child that a ray with octant o (bit a set where d[a] < 0) should visit at
// turn i ^ o. 16 texels.
#ifdef __cplusplus
struct Node {
  Child child[NODE_WIDTH];
};
#endif

// A triangle in the order of the leaves. Its corners are sorted, so that copies of one triangle are
// met at the same depth to the bit, however their files list them. 3 texels.
struct Triangle {
  vec3 a;
  uint id;  // its number in file order over all meshes
  vec3 b;
  uint more;  // triangles of the leaf that follow
  vec3 c;
  uint flipped;  // 1 if sorting turned the winding
};

// Normal indices are NO_NORMAL for a mesh without vertex normals. 1 texel.
LAVER_CONST uint NO_NORMAL = 0xffffffffu;
struct Attributes {
  uint normalA, normalB, normalC;
  uint material;
};

struct Material {
  vec3 albedo;
  float pad;
};

struct Light {
  vec3 position;  // normalised space
  float pad0;
  vec3 radiance;  // scaled to normalised space: radiance / distance^2 is in scene units
  float pad1;
};

// state(n) = multiplier * state(0) + increments * inc, 64 bits each as low, high. 1 texel.
struct Jump {
  uvec2 multiplier;
  uvec2 increments;
};

// std140: rows of 16 bytes.
struct Params {
  vec4 origin;     // camera, normalised space
  vec4 columnX;    // ray direction = columnX * (width - 2 px) + columnY * (height - 2 py) + columnZ
  vec4 columnY;
  vec4 columnZ;
  vec4 clip;       // tmin, tmax, 1 / scale of space, -
  vec4 albedo;     // of all meshes, where they agree
  uvec4 film;      // width, height, samples a pixel, reference of the root
  uvec4 seed;      // low, high, -, -
  uvec4 jumps;     // first texel of the tables by sample (low, high part), samples of the low part
  vec4 filterArgs; // radius and three numbers that filter.glsl explains
  vec4 table[9];   // Nori's table, 33 entries
};

// Push constants of both kernels.
struct Pass {
  uvec4 region;  // x, y, width, height in film pixels: what is traced, apron included
  uvec4 core;    // x, y, width, height in film pixels: what is reconstructed
  uvec4 samples; // first, count, rows of tiles, stride that permutes them
  uvec4 lights;  // first, count, 1 in the first dispatch of a pass, 1 in the last
};

// Compensated sums: value = sum + rest. rgb weighted radiance, a weight.
struct FilmPixel {
  vec4 sum;
  vec4 rest;
};

struct Status {
  uint dropped;     // samples not finite or negative, in the core
  uint incomplete;  // invocations that gave up
};

#ifdef __cplusplus
static_assert(sizeof(Child) == 32 && offsetof(Child, hi) == 16);
static_assert(sizeof(Node) == 256);
static_assert(sizeof(Triangle) == 48 && offsetof(Triangle, c) == 32);
static_assert(sizeof(Attributes) == 16);
static_assert(sizeof(Material) == 16);
static_assert(sizeof(Light) == 32 && offsetof(Light, radiance) == 16);
static_assert(sizeof(Jump) == 16);
static_assert(sizeof(Params) == 304 && offsetof(Params, film) == 96 && offsetof(Params, table) == 160);
static_assert(sizeof(Pass) == 64);
static_assert(sizeof(FilmPixel) == 32);
static_assert(sizeof(Status) == 8);
#endif

LAVER_SHARED_END

#endif
