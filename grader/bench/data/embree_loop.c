/* Traces rays one by one through a pointer to rtcIntersect1, so that no call from Python is
 * between them. The layout is that of RTCRayHit in Embree 4: 96 bytes, 16-byte aligned. */
#include <stddef.h>

typedef void (*intersect1)(void* scene, void* ray_hit, void* arguments);

void trace(intersect1 call, void* scene, char* rays, size_t count) {
    for (size_t i = 0; i < count; ++i) {
        call(scene, rays + 96 * i, NULL);
    }
}
