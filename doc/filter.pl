# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints a file for plain Doxygen. CGAL builds a manual for each package, so each chapter is a main page.
# Here, all packages are in one manual, and a chapter becomes a page with the title in its anchor. Names
# in backquotes become links. Several images of a figure stand side by side.
use strict;
use warnings;

local $/;
my $text = <>;
$text =~ s{\\mainpage User Manual[ ]*\n\\anchor Chapter_(\w+)}{
  my ($name, $title) = ($1, $1);
  $title =~ tr/_/ /;
  "\n\\page Chapter_$name $title"
}e;
$text =~ s{\\cgalFigureBegin\{(\w+),([^\}]*,[^\}]*)\}}{
  my ($name, @images) = ($1, split /,\s*/, $2);
  my $width = int(96 / @images);
  join("\n", "\\anchor $name", "<center>", map("\\image{inline} html $_ width=$width%", @images), "</center>")
}ge;
$text =~ s{`([A-Za-z_][A-Za-z_0-9:]*(?:\(\))?)`}{<code>$1</code>}g;
print $text;
