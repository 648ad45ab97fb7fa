// The `packet` traversal: a subgroup of 8 lanes traces 8 R rays in one walk of the tree. Lane c tests child c
// of a node, or triangle c of a leaf, against the frustum of all rays; then each triangle is tested against
// the rays of those lanes whose own frustum it intersects, by the same functions as in `lane`. A frustum
// contains every hit that `lane` accepts (padOf), so both find the same hits.
#include "trace/packet_incoherent.glsl"
#include "trace/packet_closest.glsl"
#include "trace/packet_unoccluded.glsl"
