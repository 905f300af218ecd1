// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_THREADS_OPTION_H
#define DSC_THREADS_OPTION_H

namespace CLI {
class App;
}

namespace dsc {

/// Returns the number of cores, clamped to the range of the option `--threads`.
unsigned default_number_of_threads();

/// Adds the option for the number of threads.
/// \param threads receives the number; it keeps its value without the option
void add_threads_option(CLI::App& command, unsigned& threads);

} // namespace dsc

#endif // DSC_THREADS_OPTION_H
