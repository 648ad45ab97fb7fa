// Linked into everything under LAVER_SANITIZE. LeakSanitizer runs at the very end: memory that a
// Vulkan driver still points to (lavapipe: 128 bytes) would count as leaked once the driver is
// unloaded, and its callers would have no names. Libraries therefore stay loaded, and no leak needs
// a suppression.
extern "C" int dlclose(void* /*library*/) noexcept { return 0; }
