// Linked into everything under LAVER_SANITIZE. LeakSanitizer looks for leaks at the very end: what
// a Vulkan driver still points to (lavapipe: 128 bytes) would count once the driver was unloaded,
// and its callers would have no names. So libraries stay, and no leak has to be excused.
extern "C" int dlclose(void* /*library*/) noexcept { return 0; }
