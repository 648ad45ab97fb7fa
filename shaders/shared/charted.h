// Bindings and intersection methods that only `laver chart` uses.
#ifndef LAVER_SHARED_CHARTED_H
#define LAVER_SHARED_CHARTED_H
#include "shared/types.h"

LAVER_SHARED_BEGIN

LAVER_CONST uint CHARTED_RAYS = 0;       // T of uvec4: origin, tmin; direction, tmax
LAVER_CONST uint CHARTED_NODES = 1;      // T Node, or quantised nodes
LAVER_CONST uint CHARTED_TRIANGLES = 2;  // T Triangle
LAVER_CONST uint CHARTED_HITS = 3;       // S vec4: normal of either sign, t
LAVER_CONST uint CHARTED_IDS = 4;        // S uint: id or NO_HIT

LAVER_CONST uint TRIANGLES_MOELLER = 0;  // Moeller and Trumbore 1997
LAVER_CONST uint TRIANGLES_PLAIN = 1;    // Woop, Benthin and Wald 2013, plain products
LAVER_CONST uint TRIANGLES_KAHAN = 2;    // the same with Kahan's difference of products
LAVER_CONST uint TRIANGLES_OURS =
    3;  // as KAHAN, with the point recomputed from the plane (point.h)

LAVER_CONST uint BOXES_PLAIN = 0;   // slabs, Kay and Kajiya 1986
LAVER_CONST uint BOXES_ROBUST = 1;  // Ize, "Robust BVH Ray Traversal", 2013
LAVER_CONST uint BOXES_OURS = 2;    // box.h

LAVER_SHARED_END

#endif
