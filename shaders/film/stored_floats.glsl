// A vec4 as kernels store it.
#define Stored vec4
Stored stored(vec4 v) { return v; }
