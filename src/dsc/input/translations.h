// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef DSC_TRANSLATIONS_H
#define DSC_TRANSLATIONS_H

#include "programs/errors.h"

#include <CGAL/Mesh_files/Unused_content.h>

#include <functional>
#include <vector>

namespace dsc {

/// Returns the path of another program in the folder of this program.
/// \throws std::runtime_error if the folder cannot be found
std::string path_of_program(const std::string& name);

/// Checks whether a program that is needed for a file is in the folder of this program.
/// \throws Input_error if it is not
void require_program(const std::string& name, const std::string& file);

/// Returns whether the extension belongs to a format that only `dsc-files` reads.
bool is_foreign(const std::string& path);

/// Translates a file of another program into a temporary file in a format that this program reads,
/// and prints what the translation leaves out. Messages name the file of the user, see
/// with_user_names().
/// \param labels, thresholds options of dsc-files; empty for none
/// \param accepts returns whether a translation is used; all are used if it is empty
/// \return the name of the translation; the same for the same file
/// \throws Input_error if the file cannot be read, the translation is not accepted, or there is no
/// program `dsc-files`
std::string translate(const std::string& path, const std::string& labels,
                      const std::string& thresholds,
                      const std::function<bool(const std::string& translation)>& accepts = {});

/// Translates an image of any format that `dsc-files` reads into an image with numeric values
/// (.inr), as above.
/// \param has_channels whether colors keep their channels; otherwise they become gray values
std::string translate_image(const std::string& path, bool has_channels);

/// Replaces names of translations in a text by the names of the files of the user.
std::string with_user_names(std::string text);
std::vector<std::string> with_user_names(const std::vector<std::string>& texts);

/// Returns a text with names of the user for a terminal: in one line, shortened in its middle if it
/// is very long, with '?' instead of control characters. Files may contain any words and names.
std::string printed_line(std::string text);

/// Writes a grid (.vtu), a surface (.ply) or an image (.vti) of this program in the format of
/// another program. The file is complete or unchanged.
/// \param like image whose axes a new image gets; empty for the axes of space
/// \throws Input_error if it cannot be written, or there is no program `dsc-files`
void write_foreign(const std::string& input, const std::string& output,
                   const std::string& like = "");

/// Lets messages name a temporary file differently, see with_user_names().
void name_in_messages(const std::string& path, const std::string& name);

/// Returns a new file name in a new temporary folder.
std::string temporary_file(const std::string& name);

/// Removes all temporary files.
void remove_temporary_files();

using DSC::Unused_content;

/// Prints the unused content of a file to the standard error, in one line, if there is any. The
/// same line is printed only once, because a run may read a file several times.
void print_unused(const std::string& path, const Unused_content& unused);

/// Suppresses the output of print_unused() from now on, as required by --quiet.
void keep_silent_about_unused();

/// Prints a choice that was made for a file, to standard error, once.
void print_note(const std::string& path, const std::string& text);

/// Returns a file in a format that this program reads, with the content of an input: the input
/// itself, or a translation if another program has written it in a format or an encoding that only
/// `dsc-files` reads. Inequalities are returned as they are.
/// \param labels name of the cell array with the labels; empty for the default
/// \param thresholds of a gray image; empty for labels
/// \throws Input_error if the file cannot be translated
std::string native_file(const std::string& path, const std::string& labels = "",
                        const std::string& thresholds = "");

} // namespace dsc

#endif // DSC_TRANSLATIONS_H
