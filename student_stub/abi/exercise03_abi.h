#ifndef EX03_ABI_H
#define EX03_ABI_H

/* The only door between the grader and a compiled submission. Plain C: no C++ type and no
 * exception crosses it. Everything is little endian and packed, floats have 32 bits:
 *   point   x, y, z
 *   face    v1, v2, v3 (uint32)
 *   node    box minimum 3 floats, box maximum 3 floats, facesBegin, facesEnd (uint32)
 *   ray     origin 3 floats, direction 3 floats, t_min, t_max
 *   hit     point 3 floats, t, normal 3 floats
 *   step    kind of test, 1 if it hit, node or EX03_NO_NODE (uint32), t, t_min, t_max of the ray
 *           as it was tested, 9 floats: box minimum and maximum, or the triangle's corners
 * Functions that copy write at most `capacity` items and return the true number of items.
 * A submission may write into whatever it is given, so meshes and trees are copied once on the
 * way in; rays and hits are not copied, and trees can be read where they lie. */

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif
#pragma GCC visibility push(default)

typedef struct ex03_mesh ex03_mesh;
typedef struct ex03_bvh ex03_bvh;

enum { EX03_POINT = 0, EX03_FACE = 1, EX03_NODE = 2, EX03_RAY = 3, EX03_HIT = 4, EX03_STEP = 5 };
enum { EX03_BOX_TEST = 0, EX03_TRIANGLE_TEST = 1 };
static const uint32_t EX03_NO_NODE = 0xffffffffU;

/* What construct and intersect return. NO_THREAD is not the submission's fault;
 * NOT_WRITTEN means that the submission does not define the function. */
enum {
    EX03_OK = 0,
    EX03_THREW = 1,
    EX03_OUT_OF_MEMORY = 2,
    EX03_NO_THREAD = 3,
    EX03_NOT_WRITTEN = 4
};

uint32_t ex03_abi_version(void);
/* Bytes of a point, face, node, ray, hit or step; 0 for anything else. */
uint64_t ex03_size_of(uint32_t what);
uint32_t ex03_max_depth(void);
uint32_t ex03_faces_per_leaf(void);

/* Copies the arrays and does not build the tree. NULL if there is not enough memory.
 * The caller makes sure that every face index is below vertex_count. */
ex03_mesh* ex03_mesh_create(const float* vertices, uint64_t vertex_count, const uint32_t* faces,
                            uint64_t face_count);
void ex03_mesh_destroy(ex03_mesh* mesh);
/* Puts other arrays into a mesh where it lies, as `mesh = Mesh(...)` does; its tree is empty. */
int32_t ex03_mesh_replace(ex03_mesh* mesh, const float* vertices, uint64_t vertex_count,
                          const uint32_t* faces, uint64_t face_count);
/* The mesh's own tree, which intersect uses. The mesh owns it: never destroy it. */
ex03_bvh* ex03_mesh_bvh(ex03_mesh* mesh);
uint64_t ex03_copy_vertices(const ex03_mesh* mesh, float* out, uint64_t capacity);
uint64_t ex03_copy_faces(const ex03_mesh* mesh, uint32_t* out, uint64_t capacity);

/* A tree of its own, next to any mesh. NULL if there is not enough memory. */
ex03_bvh* ex03_bvh_create(void);
void ex03_bvh_destroy(ex03_bvh* bvh);
int32_t ex03_construct(ex03_bvh* bvh, const ex03_mesh* mesh);

/* Views into the tree: valid until it is constructed, set or destroyed. */
const void* ex03_nodes(const ex03_bvh* bvh);
const uint32_t* ex03_face_indices(const ex03_bvh* bvh);
uint64_t ex03_copy_nodes(const ex03_bvh* bvh, void* out, uint64_t capacity);
uint64_t ex03_copy_face_indices(const ex03_bvh* bvh, uint32_t* out, uint64_t capacity);
/* Replaces the tree by one that was made elsewhere. */
int32_t ex03_set_tree(ex03_bvh* bvh, const void* nodes, uint64_t node_count,
                      const uint32_t* face_indices, uint64_t face_count);

typedef struct {
    const void* rays;
    uint64_t count;
    void* hits;
    uint32_t* tests; /* NULL, or 2 per ray: calls of the box test, calls of the triangle test */
    uint64_t* done;  /* NULL, or rays finished so far, to be watched from outside */
} ex03_batch;

/* Traces the rays in order; equal ones in a row are one `IntersectionRay`, asked again.
 * After an exception the remaining hits are untouched. */
int32_t ex03_intersect(const ex03_mesh* mesh, const ex03_batch* batch);
/* Every thread traces all rays, released at the same moment. Hits, and tests if given, hold one
 * batch per thread, one after the other; done counts the rays of all threads. */
int32_t ex03_intersect_threads(const ex03_mesh* mesh, const ex03_batch* batch, uint32_t threads);

typedef struct {
    const void* ray;
    void* hit;
    void* steps; /* at most `capacity` of them are written */
    uint64_t capacity;
    uint64_t* count; /* the true number of steps; untouched after an exception */
} ex03_recording;

/* Traces one ray and records its calls of the given tests, in order. */
int32_t ex03_record(const ex03_mesh* mesh, const ex03_recording* recording);

/* Calls of the box test and of the triangle test on this thread, and on those that
 * ex03_intersect_threads started from it. */
void ex03_read_counters(uint64_t out[2]);
void ex03_reset_counters(void);

/* what() of the last exception, shortened if it is long, with a final zero if it fits.
 * Returns its length without the zero; empty if nothing was thrown yet. */
uint64_t ex03_last_error(char* out, uint64_t capacity);

#pragma GCC visibility pop
#ifdef __cplusplus
}
#endif

#endif
