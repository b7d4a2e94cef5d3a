/* All variant tables: what list prints, --help offers, and scene files may name. */
#include "backend/backend.h"
#include "backend/cpu/isa.h"
#include "compare/gate.h"
#include "encode/codec.h"
#include "encode/encode.h"
#include "grid/search.h"
#include "particles/flows.h"
#include "render/color.h"
#include "render/render.h"
#include "run/measure.h"
#include "run/run.h"
#include "solver/solver.h"

static const struct variant_table *const tables[] = {
    &solver_table,    &kernel_table,   &search_table, &backend_table, &isa_table,
    &render_table, &encode_table,   &color_table,  &render_maps,
    &render_overlays, &measure_table,  &flow_table,   &metric_table,  &gate_table,
    &codec_table,
};

const struct vocabulary run_vocabulary = {tables, sizeof tables / sizeof *tables};
