// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_INTERRUPT_H
#define DSC_INTERRUPT_H

namespace dsc {

/// From now on the first SIGINT or SIGTERM only raises a flag; one some seconds later ends the
/// program.
void catch_interrupts();

/// Whether a signal arrived.
bool interrupted();

} // namespace dsc

#endif // DSC_INTERRUPT_H
