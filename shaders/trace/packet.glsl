// The `packet` traversal: a subgroup of 8 lanes traces 8 R rays through one walk of the tree. Lane c
// tests child c of a node, or triangle c of a leaf, against the frustum of all rays; then triangles are
// tested against the rays of those lanes that may meet them, with the text that `lane` uses. A frustum
// holds every hit that `lane` accepts (padOf), so both find the same.
#include "trace/packet_incoherent.glsl"
#include "trace/packet_closest.glsl"
#include "trace/packet_unoccluded.glsl"
