// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "motions/array_visitor.h"
#include "motions/motion_step.h"
#include "motions/tracked_complex_3.h"

namespace dsc {

Step_outcome Tracked_complex_3::advance(const Step_options& options, double time,
                                        unsigned threads) {
  if (!carries_arrays())
    return do_step(complex, options, time, threads);
  Array_visitor<Complex> visitor(complex, m_carried);
  const Step_outcome outcome = do_step(complex, options, time, threads, &visitor);
  m_carried = visitor.finish();
  return outcome;
}

} // namespace dsc
