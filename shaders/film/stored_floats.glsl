// The type in which kernels store a vec4.
#define Stored vec4
Stored stored(vec4 v) { return v; }
