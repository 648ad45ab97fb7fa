// Every struct, binding number and constant that host and device share.
#ifndef LAVER_SHARED_LAYOUT_H
#define LAVER_SHARED_LAYOUT_H
#include "shared/types.h"

LAVER_SHARED_BEGIN

// Bindings of descriptor set 0. T: texel buffer of uvec4, S: storage buffer, U: uniform buffer.
LAVER_CONST uint BIND_PARAMS = 0;          // U Params
LAVER_CONST uint BIND_NODES = 1;           // T Node
LAVER_CONST uint BIND_TRIANGLES = 2;       // T Triangle
LAVER_CONST uint BIND_ATTRIBUTES = 3;      // T Attributes, or their smaller form, one per triangle
LAVER_CONST uint BIND_NORMALS = 4;         // T vec4, one per vertex normal
LAVER_CONST uint BIND_MATERIALS = 5;       // T of words: MaterialLayout (host/kernels/keys.h)
LAVER_CONST uint BIND_LIGHTS = 6;          // T Light
LAVER_CONST uint BIND_JUMPS = 7;           // T Jump
LAVER_CONST uint BIND_SAMPLES = 8;         // S vec4, one per sample: r, g, b, x in the pixel
LAVER_CONST uint BIND_SAMPLES_Y = 9;       // S float, one per sample: y inside its pixel
LAVER_CONST uint BIND_FILM = 10;           // S FilmPixel
LAVER_CONST uint BIND_STATUS = 11;         // S Status, answers
LAVER_CONST uint BIND_SAMPLE_TEXELS = 12;  // T of vec4: BIND_SAMPLES, for reading
LAVER_CONST uint BIND_SAMPLE_Y_TEXELS = 13;  // T of vec4: BIND_SAMPLES_Y, for reading
LAVER_CONST uint BIND_COUNTS = 14;    // T Count, one per cell of the region; adaptive sampling only
LAVER_CONST uint BIND_WORK = 15;      // T Work; adaptive sampling only
LAVER_CONST uint BIND_TEXTURES = 16;  // T Texture
LAVER_CONST uint BIND_UVS = 17;       // T of uvec2: u, v of each corner of textured triangles
LAVER_CONST uint BIND_IMAGES = 18;    // T of uint: pixels of all images, and their tables
LAVER_CONST uint BIND_EMISSION = 19;  // T Emission, one per mesh
LAVER_CONST uint BIND_SOURCES = 20;   // T Source
LAVER_CONST uint BINDINGS = 21;

// A dispatch sums at most this many lights, so that an invocation stays far below lavapipe's 65,535
// loop iterations.
LAVER_CONST uint LIGHTS_PER_DISPATCH = 8;

LAVER_CONST uint GATHER_GROUP = 64;  // columns
LAVER_CONST uint SLOT_COLUMNS = 8;   // pixels of a row whose samples are stored together
// Samples of a pixel that are added without compensation before their sum enters the compensated
// sum. A pass holds a multiple of them, so that splitting a render into passes does not change a
// bit.
LAVER_CONST uint GATHER_SAMPLES = 8;
// The x of a sample that is left out of the image: no filter reaches it.
LAVER_CONST float DROPPED = 1e6f;

// Upper bound of the loop iterations that the host gives to an invocation; lavapipe ends loops
// after 65,535.
LAVER_CONST uint MAX_ITERATIONS = 60000;

// A child reference is REF_NONE, the index of a node, or for a leaf REF_LEAF | (triangles - 1) <<
// REF_COUNT_SHIFT | first slot.
LAVER_CONST uint REF_NONE = 0xffffffffu;
LAVER_CONST uint REF_LEAF = 0x80000000u;
LAVER_CONST uint REF_COUNT_SHIFT = 28;
LAVER_CONST uint REF_INDEX_MASK = 0x0fffffffu;
LAVER_CONST uint NODE_WIDTH = 8;
LAVER_CONST uint MAX_LEAF = 8;  // triangles

LAVER_CONST uint NO_HIT = 0xffffffffu;

// tmax of rays without an end: times a direction it is finite.
LAVER_CONST float FAR_AWAY = 1e37f;

// A point light nearer than 2^-50 of the scene, far below the rounding of positions, lies on the
// surface; squared.
LAVER_CONST float ON_SURFACE = 7.8886091e-31f;

// One child of a node: its padded box and its reference. 2 texels.
struct Child {
  vec3 lo;
  uint ref;
  vec3 hi;
  uint count;  // primitives of a leaf, 0 for a node
};

// A ray of octant o (bit a is set where d[a] < 0) tests child i ^ o in step i, so that it reaches
// the children roughly front to back. 16 texels.
#ifdef __cplusplus
struct Node {
  Child child[NODE_WIDTH];
};
#endif

// A triangle in the order of the leaves. Its corners are sorted, so that copies of one triangle are
// hit at the same depth to the bit, in whatever order their files list the corners. 3 texels. Or a
// sphere, for which `flipped` is IS_SPHERE: `a` is its centre, b.x its radius. Or one of which
// only a small part is near (cap.h), behind those of the tree: `a` is its nearest point, `b` its
// normal there, c.x its curvature.
LAVER_CONST uint IS_SPHERE = 2;
LAVER_CONST uint IS_CAP = 3;
struct Triangle {
  vec3 a;
  uint id;  // its number in file order over all meshes
  vec3 b;
  uint more;  // number of triangles that follow in the leaf
  vec3 c;
  uint flipped;  // 1 if sorting reversed the winding
};

// Vertex attributes of a triangle. Normal indices are NO_NORMAL for a mesh without vertex normals;
// entry 0 of the normals is unused. 1 texel of four numbers, or of the material alone where no
// kernel of the scene reads normals.
LAVER_CONST uint NO_NORMAL = 0;
struct Attributes {
  uint material;  // first, since both forms have it
  uint normalA, normalB, normalC;
};

// An image: pixels from texel `first` on, rows from the top. Bytes are looked up in a table of 256
// floats that begins at texel `table`; with NO_TABLE the pixels are floats.
LAVER_CONST uint NO_TABLE = 0xffffffffu;
struct ImageRef {
  uint first, width, height, table;
};

// A texture of a property of a material, evaluated at (s, t) = uv * scale + offset. 4 texels.
LAVER_CONST uint TEXTURE_NONE = 0;  // in materials' records, where 1 + the texture's index stands
struct Texture {
  vec3 color1;
  uint kind;  // index among the textures of the kernel's key
  vec3 color2;
  uint uvs;  // texels 3 * (id + uvs) + 0 to 2 hold the uv of the stored corners of triangle `id`
  vec2 scale;
  vec2 offset;
  ImageRef image;
};

struct Light {
  vec3 position;  // normalised space
  float outer;    // of a spot: where its intensity is 0, as emitter/shaped.glsl measures it
  vec3 radiance;  // scaled to normalised space: radiance / distance^2 is in scene units
  float ramp;     // of a spot: 1 / (where its intensity is full - outer)
  vec3 axis;      // unit; along which the light travels
  uint shape;     // LIGHT_...
};

LAVER_CONST uint LIGHT_POINT = 0;
LAVER_CONST uint LIGHT_DIRECTIONAL = 1;     // the same radiance everywhere, from -axis
LAVER_CONST uint LIGHT_SPOT_ANGLE = 2;      // falls linearly in the angle
LAVER_CONST uint LIGHT_SPOT_SQUARE = 3;     // falls as the square of what is linear in the cosine
LAVER_CONST uint LIGHT_SPOT_QUARTIC = 4;    // as its fourth power
LAVER_CONST uint LIGHT_SPOT_PROJECTED = 5;  // the same, times the cosine

// Light that a mesh emits on the side of its shading normal. 2 texels.
struct Emission {
  vec3 radiance;  // or factor of the texture
  float
      density;  // of light sampling, per area of normalised space, before probabilities are rounded
  uint shown;   // 1 + the texture's index, or TEXTURE_NONE
  uint unused0, unused1, unused2;
};

// A light source of light sampling, which draws one of all. 1 texel.
LAVER_CONST uint SOURCE_POINT = 0;       // `index`: of its Light
LAVER_CONST uint SOURCE_BACKGROUND = 1;  // `index`: of the image's cell
LAVER_CONST uint SOURCE_PRIMITIVE = 2;   // `index`: its slot
struct Source {
  uint kind;
  uint index;
  float upper;  // sum of the probabilities up to and with this one, in 2^-23
  float probability;
};

// state(n) = multiplier * state(0) + increments * inc, 64 bits each as low, high. 1 texel.
struct Jump {
  uvec2 multiplier;
  uvec2 increments;
};

// Adaptive sampling chooses one sample count per cell of CELL x CELL pixels of the film, in steps
// of CELL_STEP samples per pixel: 64 samples, a workgroup of the trace kernel. Blocks of 2 x 2
// cells can have one sample per pixel, which is 64 samples, too.
LAVER_CONST uint CELL = 4;
LAVER_CONST uint CELL_STEP = 4;
// Adaptive sampling gathers by strips of STRIP_COLUMNS x STRIP_ROWS pixels.
LAVER_CONST uint STRIP_COLUMNS = 8;
LAVER_CONST uint STRIP_ROWS = 16;

// Samples per pixel of a cell. 1 texel.
struct Count {
  uint samples;
  uint pad0, pad1, pad2;
};

// The work of one workgroup. Trace: (x, y) is the corner of its tile in pixels of the region
// (modulo 2^32, since cells may begin outside of it), `number` its first sample in the pass.
// Gather, with GATHER_GROUP / STRIP_COLUMNS of these per workgroup: (x, y) is the strip of the
// core, counted in strips, `number` the samples of the pass. 1 texel.
struct Work {
  uint x, y;
  uint number;
  uint pad;
};

// std140: rows of 16 bytes.
struct Params {
  vec3 origin;         // of the camera, or the middle of the plane where its rays start
  float packetWindow;  // greatest difference between the slopes of rays in one walk
  vec3 columnX;  // ray direction = columnX * (width - 2 px) + columnY * (height - 2 py) + columnZ
  float tmin;
  vec3 columnY;
  float tmax;
  vec3 columnZ;
  float sceneUnits;    // scene units per unit of normalised space
  vec3 albedo;         // of all meshes, if they have the same
  uint root;           // child reference of the root
  uvec2 filmSize;      // width, height
  uint sampleCount;    // per pixel
  uint halfStep;       // half a step of the sample grid, in 2^-32 pixels
  uvec2 seed;          // low, high
  uint seedHash;       // of both
  float filterRadius;  // pixels
  // independent: first texel of the tables by sample (low, high part), samples of the low part;
  // stratified: strata along y, size of a stratum along x and y in 2^-32 pixels
  uvec4 samplerArguments;
  // Of the integrator, in the order of its table row, without gaps; lengths in normalised space.
  vec4 properties[2];
  vec3 lensX;             // thinlens: the lens's half axes in normalised space
  float lensToDirection;  // factor of a point of the lens in a ray's direction
  vec3 lensY;
  float lensAtStart;  // the share of a point of the lens that is left where rays start
  vec2 filterShape;   // meaning: see filter/NAME.glsl
  uint firstCap;      // slot
  uint capCount;
  vec3 startX;   // rays start at startX * (width - 2 px) + startY * (height - 2 py) + origin
  float startT;  // t there, from the camera
  vec3 startY;
  float sceneReach;  // no two points of the scene are farther apart
  vec4
      filterTable[9];  // filter/table.glsl: 33 entries; filter/gaussian_narrow.glsl: exp(alpha k^2)
  vec3 backgroundX;    // rows of the rotation from world space to the background image's space
  float backgroundVersine;  // distantdisk: 1 - cos of its angular radius
  vec3 backgroundY;
  float backgroundProbability;  // that light sampling draws the background
  vec3 backgroundZ;
  uint sources;  // light sources of light sampling
  vec3 backgroundRadiance;
  uint backgroundSource;  // the first source of the background
  vec3 backgroundAxis;    // distantdisk: unit vector to its centre
  float cellDensity;      // of light sampling, see emitter/environment.glsl
  uvec2 backgroundCells;  // columns and rows of the image's grid for light sampling
  vec2 pad3;
  ImageRef backgroundImage;
};

// Maximum number of primitives of a portion of the tree. If the 8 lanes of a subgroup visit all of
// them one after another, at 5 iterations for a primitive and its nodes, a walk takes 40,960, below
// MAX_ITERATIONS.
LAVER_CONST uint PORTION_PRIMITIVES = 1024;
LAVER_CONST uint ALL_ANSWERED = 0xffffffffu;

// Push constants of the trace and gather kernels. Booleans are 0 or 1.
struct Pass {
  uvec4 region;  // x, y, width, height in film pixels: traced, apron included
  uvec4 core;    // x, y, width, height in film pixels: reconstructed
  // First x and y, end of x and y: the part of the region that this dispatch traces, or the part of
  // the core that it gathers.
  uvec4 part;
  uint firstSample;
  uint sampleCount;     // per pixel in this pass
  uint sideShift;       // trace: log2 of the samples per pixel that a workgroup traces side by side
  uint dispatchSample;  // trace: first sample of the dispatch, counted from firstSample
  uint tileRows;        // trace: rows of tiles
  uint rowStride;       // trace: stride that permutes the rows of tiles
  uint stripRows;       // gather: rows of pixels per invocation
  uint firstWork;       // adaptive: the first Work of the dispatch
  uint firstLight;
  uint lightCount;
  uint firstDispatch;  // 1 for the first dispatch of the pass, if its lights take several
  uint lastDispatch;
  // Of trace/portions.glsl: the first query that the dispatch answers, the portion of the tree that
  // it walks, or ALL_ANSWERED, the portion's root, and the number of queries that it answers.
  uint query;
  uint portion;
  uint root;
  uint queryCount;
};

// Compensated sums: value = sum + rest; rgb is weighted radiance, a the weight. With
// film/centres.glsl instead: sum = position in normalised space, distance in scene units or 0 for
// no hit; rest = weights of the second and third corner as stored, or a sphere's u and v, then the
// low and the high 16 bits of the triangle's id, which floats hold exactly.
struct FilmPixel {
  vec4 sum;
  vec4 rest;
};

struct Status {
  uint dropped;     // samples not finite or negative, in the core
  uint incomplete;  // invocations whose loops were cut short
  uint queries;     // maximum number of queries of an invocation (trace/portions.glsl)
};

#ifdef __cplusplus
static_assert(sizeof(Child) == 32 && offsetof(Child, hi) == 16);
static_assert(sizeof(Node) == 256);
static_assert(sizeof(Triangle) == 48 && offsetof(Triangle, c) == 32);
static_assert(sizeof(Attributes) == 16);
static_assert(sizeof(Texture) == 64 && offsetof(Texture, image) == 48);
static_assert(sizeof(Light) == 48 && offsetof(Light, radiance) == 16);
static_assert(sizeof(Jump) == 16 && sizeof(Emission) == 32 && sizeof(Source) == 16);
static_assert(sizeof(Count) == 16 && sizeof(Work) == 16);
static_assert(sizeof(Params) == 496 && offsetof(Params, filmSize) == 80);
static_assert(sizeof(Pass) == 112);
static_assert(sizeof(FilmPixel) == 32);
static_assert(sizeof(Status) == 12);
#endif

LAVER_SHARED_END

#endif
