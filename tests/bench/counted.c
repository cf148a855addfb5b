/* Builds one tree and traces rays on it, so that callgrind can count the instructions of a
 * graded library: counted LIBRARY INPUT, where INPUT holds the numbers of vertices, faces and
 * rays as uint64, and then all of them as the library reads them. */
#include "exercise03_abi.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>

static void* read_all(FILE* file, uint64_t count, size_t size) {
    void* space = malloc(count * size);
    return space != NULL && fread(space, size, count, file) == count ? space : NULL;
}

int main(int argc, char** argv) {
    uint64_t counts[3];
    void* library = argc == 3 ? dlopen(argv[1], RTLD_NOW) : NULL;
    FILE* file = library != NULL ? fopen(argv[2], "rb") : NULL;
    if (file == NULL || fread(counts, sizeof counts, 1, file) != 1) {
        return 1;
    }
    float* vertices = read_all(file, counts[0], 12);
    uint32_t* faces = read_all(file, counts[1], 12);
    void* rays = read_all(file, counts[2], 32);
    void* hits = malloc(counts[2] * 28);
    if (vertices == NULL || faces == NULL || rays == NULL || hits == NULL) {
        return 1;
    }
    ex03_mesh* (*create)(const float*, uint64_t, const uint32_t*, uint64_t);
    ex03_bvh* (*tree)(ex03_mesh*);
    int32_t (*construct)(ex03_bvh*, const ex03_mesh*);
    int32_t (*intersect)(const ex03_mesh*, const ex03_batch*);
    *(void**)&create = dlsym(library, "ex03_mesh_create");
    *(void**)&tree = dlsym(library, "ex03_mesh_bvh");
    *(void**)&construct = dlsym(library, "ex03_construct");
    *(void**)&intersect = dlsym(library, "ex03_intersect");
    ex03_mesh* mesh = create(vertices, counts[0], faces, counts[1]);
    ex03_batch batch = {rays, counts[2], hits, NULL, NULL};
    return construct(tree(mesh), mesh) != EX03_OK || intersect(mesh, &batch) != EX03_OK;
}
