// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/motion_step.h"
#include "motions/tracked_complex_3.h"

namespace dsc {

Step_outcome Tracked_complex_3::advance(const Step_options& options, double time,
                                        unsigned threads) {
  return do_step(complex, options, time, threads);
}

} // namespace dsc
