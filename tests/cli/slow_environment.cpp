// Preloaded (LD_PRELOAD): delays every lookup of lavapipe's vector width. For every kernel that it compiles, Mesa
// 25.0.7 sets the width to that of half the lanes before the lookup, and other threads may read it meanwhile; the delay
// makes this visible.
#include <chrono>
#include <cstring>
#include <dlfcn.h>
#include <thread>

namespace {

char* lookUp(const char* function, const char* name) {
    if (std::strcmp(name, "LP_NATIVE_VECTOR_WIDTH") == 0) {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
    }
    return reinterpret_cast<char* (*)(const char*)>(dlsym(RTLD_NEXT, function))(name);
}

} // namespace

extern "C" {
char* getenv(const char* name) noexcept {
    return lookUp("getenv", name);
}
char* secure_getenv(const char* name) noexcept {
    return lookUp("secure_getenv", name);
}
}
