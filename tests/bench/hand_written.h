// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/evaluate/affine_evaluator.h"
#include "tests/bench/bench_functions.h"

namespace isoscope::bench {

/// out[i] = function(x[i], y[i], z[i]) for batchLanes points, as a programmer would write it for this one
/// function with vector types: every formula compiled (-O3) for each instruction set, without tape and
/// interpreter, intermediate values in registers.
void handWrittenPoints(BenchFunction function, const double* x, const double* y, const double* z,
                       double* out);

/// The same for affine forms along the pieces: centers, slopes and errors one behind the other in `out`.
void handWrittenForms(BenchFunction function, const RayPieces& pieces, double* out);

}  // namespace isoscope::bench
