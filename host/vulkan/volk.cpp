// The only definition of volk's function table.
#define VOLK_IMPLEMENTATION
#include <volk.h>
