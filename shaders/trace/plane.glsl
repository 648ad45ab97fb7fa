// The normal, of any length, that decides on which side of a triangle's plane a point lies.
#include "shared/point.h"

vec3 planeNormal(vec3 u, vec3 v) { return HAS_SLIVERS ? accurateCross(u, v) : crossProduct(u, v); }
