// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "command_line.h"
#include "commands.h"
#include "errors.h"
#include "unused.h"

#include <CGAL/assertions.h>

#include <algorithm>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace {

enum Exit_code { bad_input = 1, bad_usage = 2 };

int fail(std::string message, Exit_code code) {
  std::replace(message.begin(), message.end(), '\n', ' ');
  std::cerr << "dsc: " << message << '\n';
  return code;
}

// CGAL throws after it has printed; the message comes with the exception.
void print_nothing(const char*, const char*, const char*, int, const char*) {}

bool is_quiet(const dsc::Info_options&) { return false; }
template <class Command> bool is_quiet(const Command& command) { return command.quiet; }

} // namespace

int main(int argc, char** argv) {
  CGAL::set_error_handler(print_nothing);
  CGAL::set_warning_handler(print_nothing);
  try {
    const std::optional<dsc::Options> options = dsc::parse_command_line(argc, argv);
    if (!options)
      return 0;
    if (std::visit([](const auto& command) { return is_quiet(command); }, *options))
      dsc::keep_silent_about_unused();
    return std::visit([](const auto& command) { return dsc::execute(command); }, *options);
  } catch (const dsc::Usage_error& error) {
    return fail(error.what(), bad_usage);
  } catch (const std::bad_alloc&) {
    return fail("there is not enough memory; choose fewer --triangles or a smaller mesh",
                bad_input);
  } catch (const std::exception& error) {
    return fail(error.what(), bad_input);
  } catch (...) {
    return fail("something unknown went wrong; check the input", bad_input);
  }
}
