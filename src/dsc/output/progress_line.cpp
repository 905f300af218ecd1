// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "output/progress_line.h"

#include <cstdio>
#include <string>

#include <unistd.h>

namespace dsc {
namespace {

std::string duration(double seconds) {
  const long s = static_cast<long>(seconds + 0.5);
  char text[32];
  if (s < 60)
    std::snprintf(text, sizeof text, "%ld s", s);
  else if (s < 3600)
    std::snprintf(text, sizeof text, "%ld min %02ld s", s / 60, s % 60);
  else
    std::snprintf(text, sizeof text, "%ld h %02ld min", s / 3600, s / 60 % 60);
  return text;
}

} // namespace

bool shows_lines() { return isatty(STDERR_FILENO) == 1; }

Progress_line::Progress_line(unsigned steps, bool quiet, const char* unit)
    : m_steps(steps), m_unit(unit), m_enabled(!quiet && shows_lines()),
      m_start(std::chrono::steady_clock::now()) {}

void Progress_line::show(unsigned done) {
  if (!m_enabled)
    return;
  std::string remaining = "?";
  if (done > 0) {
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - m_start;
    remaining = duration(elapsed.count() / done * (m_steps - done));
  }
  std::fprintf(stderr, "\r\033[K%s %u of %u, %s remaining", m_unit, done, m_steps,
               remaining.c_str());
  std::fflush(stderr);
  m_shown = true;
}

void Progress_line::clear() {
  if (m_shown)
    std::fputs("\r\033[K", stderr);
  m_shown = false;
}

} // namespace dsc
