// SPDX-License-Identifier: Apache-2.0
// The megakernel: one work-item, one pixel of a tile, one block of samples.
#include "lobe_scene.h"

#include "path/block.h"
#include "path/film.h"

kernel WIDE_WORK_ITEMS void render(
    global const LobeFrame* frame, global const LobeNode* nodes,
    global const LobeTriangleLeaf* triangle_leaves, global const LobeSphereLeaf* sphere_leaves,
    global const LobeTriangle* triangles, global const LobeVertex* vertices,
    global const LobeSphere* spheres, global const LobeSurface* surfaces,
    global const LobeMaterial* materials, global const uchar* prepared,
    global const LobeLight* lights, global const LobeLightNode* light_nodes,
    global const float* tables, global const float* filter, global const LobeTileJob* jobs,
    global LobeBlockSum* sums, global uint* status, global uint* statistics) {
    uint slot = get_global_id(1) / LOBE_TILE;
    uint2 place = (uint2)(get_global_id(0), get_global_id(1) % LOBE_TILE);
    if (place.x >= LOBE_TILE || slot >= frame->tiles) return;
    LobeTileJob job = jobs[slot];
    uint2 corner = (uint2)(job.tile % frame->tiles_across, job.tile / frame->tiles_across);
    uint2 window = corner * LOBE_TILE + place;
    if (window.x >= frame->window_width || window.y >= frame->window_height) return;
    Scene scene = {{nodes, triangle_leaves, sphere_leaves},
                   {triangles, vertices, spheres, surfaces, frame->triangles},
                   {lights, light_nodes, frame->lights, frame->light_root},
                   materials,
                   prepared,
                   tables};
    uint2 pixel = (uint2)(frame->window_x, frame->window_y) + window;
    uint number = pixel.y * frame->film_width + pixel.x;
    LobeBlockSum sum[LOBE_REPLICATES] = {{0, 0, 0, 0}};
    PathCounts counts = no_counts();
    uint last = job.first_sample + frame->samples;
    for (uint first = job.first_sample; first < last; first += LOBE_ABREAST) {
        Path paths[LOBE_ABREAST];
        uint lanes = min(last - first, (uint)LOBE_ABREAST);
        trace_paths(&scene, frame, filter, pixel, number, first, lanes, paths, &counts);
        for (uint lane = 0; lane < lanes; ++lane)
            add_sample(&sum[(first + lane) % LOBE_REPLICATES], &paths[lane], status, number,
                       first + lane);
    }
    ulong out = ((ulong)get_global_id(1) * LOBE_TILE + place.x) * LOBE_REPLICATES;
    for (uint i = 0; i < LOBE_REPLICATES; ++i) sums[out + i] = sum[i];
    if (frame->lights == 0) counts.light_useless = 0;  // none was sent for
    add_counts(statistics + (ulong)slot * LOBE_STATISTIC_COUNT, &counts);
}

// Makes every material's prepared form, once before the first launch.
kernel WIDE_WORK_ITEMS void prepare(global const LobeMaterial* materials,
                                    global const LobeRow* rows, global uchar* prepared, uint count,
                                    global uint* status) {
    uint i = get_global_id(0);
    if (i >= count) return;
    if (!prepare_material(materials[i].model, rows + materials[i].first_row,
                          prepared + (ulong)i * LOBE_PREPARED_BYTES)) {
        atomic_inc(&status[LOBE_STATUS_TRAP]);
    }
}
