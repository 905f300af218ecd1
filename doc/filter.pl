# Copyright (c) 2026 The deformable simplicial complex authors
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Prints a file for plain Doxygen. CGAL builds a manual for each package, so each chapter is a main page.
# Here, all packages are in one manual, and a chapter becomes a page with the title in its anchor. Names
# in backquotes become links. Several images of a figure stand side by side. Citations become links to the
# works in biblio/, which \cgalBibliography lists; CGAL's manual uses BibTeX. References to packages of CGAL
# become text, and references to packages of this project become links to their reference manuals.
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

# The works of the bibliography by their keys, numbered in the order of the file
my (%number, @works);
{
  open(my $file, "<", "biblio/deformable_simplicial_complexes.bib") or die "the bibliography is missing";
  my %accents = ('{\ae}' => '&aelig;', '{\"o}' => '&ouml;', '{\"u}' => '&uuml;', '{\c c}' => '&ccedil;');
  my $works = <$file>;
  while ($works =~ m/\@\w+\{ (\S+)\n(.*?)\n\}/gs) {
    my ($key, $fields, %field) = ($1, $2);
    $fields =~ s/(\{\\[^}]*\})/$accents{$1} \/\/ die "no letter for $1"/ge;
    $fields =~ s/[{}]//g;
    $field{$1} = $2 while $fields =~ m/, (\w+) =\s+"?(.*?)"?$/gm;
    (my $authors = $field{author}) =~ s/ and (?=.* and )/, /g;
    my $where = $field{journal} // $field{booktitle} // $field{note};
    $where .= " $field{volume}" . ($field{number} ? "($field{number})" : "") if $field{volume};
    push @works, "\\anchor " . anchor($key) . " [" . (@works + 1) . "] $authors. $field{title}. <em>$where</em>, $field{year}.\n";
    $number{$key} = scalar @works;
  }
}

# Returns the name of the anchor of a work.
sub anchor {
  (my $name = "cite_" . shift) =~ tr/a-zA-Z0-9/_/c;
  return $name;
}

$text =~ s{\\cgalCite\{([^\}]*)\}}{
  die "$1 is not in the bibliography" unless $number{$1};
  "\\ref " . anchor($1) . " \"[$number{$1}]\""
}ge;
$text =~ s{\\cgalBibliography}{join("\n", @works)}e;

# Packages
$text =~ s{\\ref (Pkg\w+?)(Ref)?\b(?! ".*NamedParameters)( "[^"]*")?}{reference($1, $2, $3)}ge;
$text =~ s{\\ref licensesGPL "GPL"}{GPL}g;

# Returns a reference to a package, or its name if it belongs to CGAL.
sub reference {
  my ($name, $suffix, $title) = @_;
  return "\\ref $name" . ($suffix // "") . ($title // "") if $name =~ /(?:NamedParameters|Concepts)$/;
  my ($folder) = grep { (my $plain = lc) =~ tr/_//d; $plain eq lc substr($name, 3) }
    map { m{([^/]+)/PackageDescription.txt} } glob("*/PackageDescription.txt");
  (my $words = $title // " \"" . ($folder // substr($name, 3)) . "\"") =~ s/^ "|"$//g;
  $words =~ s/_/ /g;
  $words =~ s/(?<=[a-z])(?=[A-Z0-9])/ /g unless $folder or $title;
  return $folder ? "\\ref ${name}Ref \"$words\"" : $words;
}

$text =~ s{`([A-Za-z_][A-Za-z_0-9:]*(?:\(\))?)`}{<code>$1</code>}g;
print $text;
