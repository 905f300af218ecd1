// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_FILES_THRESHOLDS_H
#define DSC_FILES_THRESHOLDS_H

#include <string>
#include <vector>

namespace dsc_files {

/// Returns the increasing thresholds of an option: numbers separated by commas, `otsu`, or `otsu:K`
/// for K thresholds that are chosen by the values.
/// \throws Failure if the option cannot be read
std::vector<double> thresholds_of(const std::string& option, const std::vector<double>& values);

/// Returns the thresholds that maximize the variance between the classes of values (N. Otsu, "A
/// threshold selection method from gray-level histograms", 1979), with a histogram of 256 classes.
/// Values that are not finite are ignored.
/// \param number from 1 to 8
/// \throws Failure if there are not enough different values
std::vector<double> otsu_thresholds(const std::vector<double>& values, int number);

} // namespace dsc_files

#endif // DSC_FILES_THRESHOLDS_H
