// Copyright (c) 2026 The deformable simplicial complex authors. All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
// Author(s)     : The deformable simplicial complex authors

#ifndef CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MESH_OPERATIONS_H
#define CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MESH_OPERATIONS_H

#include <CGAL/Deformable_simplicial_complexes/internal/proposals/commit_proposal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/degeneracy_removal.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_collapse.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_flip_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/edge_split.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/multi_face_removal_3.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/neighbor_exchange_2.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/relabeling.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/vertex_insertion.h>
#include <CGAL/Deformable_simplicial_complexes/internal/proposals/vertex_smoothing.h>

/// \file
/// Mesh operations: proposals that leave the complex as it is, and their commits. The internal
/// headers define the functions that this header declares.

namespace CGAL::Deformable_simplicial_complexes {

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to split an edge at a point. Each cell around the edge is divided into two, which keep its
label. The new vertex is on the sides of the domain that contain the edge. Linear in the number of
cells around the edge.

\param complex the complex; it is not changed
\param cell, i, j the edge between the finite vertices i and j of the cell
\param point position of the new vertex. If it is not on the edge, the interface changes
       accordingly.
\param cavity filled with the proposal if there is one; its last vertex is the new one
\return whether all new cells are positively oriented and `complex.keeps_quality()` holds
\pre if the edge is on the boundary of the domain, the point is on the edge, up to rounding
*/
template <class Complex>
bool propose_edge_split(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                        const typename Complex::Point& point,
                        Deformable_simplicial_complexes::Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to split an edge at the fraction `ratio` of the vector from i to j, in (0, 1). The
interface moves only by the rounding of the point. Otherwise the function is the same as the
overload above.
*/
template <class Complex>
bool propose_edge_split(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                        double ratio, Deformable_simplicial_complexes::Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to collapse an edge. The first vertex is removed; the second one stays in place. n log n in
the size of the two stars.

\param complex the complex; it is not changed
\param cell, i, j the edge from the vertex i of the cell, which is removed, to the vertex j, which
       stays
\param minimum_quality lower bound of the quality of the new cells
\param cavity filled with the proposal if there is one
\return whether the collapse keeps the topology, is compatible with all lower-dimensional features,
        and creates only positively oriented cells of sufficient quality. The topology of cells, of
        the interface, and of the lines where labels meet is tested with exact link conditions.
        Sides of the domain, sheets, and lines and points where labels meet stay in place or move
        only along themselves.
*/
template <class Complex>
bool propose_edge_collapse(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                           double minimum_quality,
                           Deformable_simplicial_complexes::Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to collapse an edge that is too short, in one of the two directions. Section 3.2.1 of the
paper, degeneracy removal (c). The complexity is that of `propose_edge_collapse()`.

\param complex the complex; it is not changed
\param cell, i, j the edge between the finite vertices i and j of the cell
\param minimum_length only shorter edges are considered; the paper uses half the length of the
       shortest edge of the input's interface
\param minimum_quality lower bound of the quality of the new cells
\param cavity filled with the proposal if there is one
\return whether the edge is short and `propose_edge_collapse()` proposes its collapse
*/
template <class Complex>
bool propose_degenerate_edge_removal(const Complex& complex, typename Complex::Cell_handle cell,
                                     int i, int j, double minimum_length, double minimum_quality,
                                     Deformable_simplicial_complexes::Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to insert a vertex: a set of cells around a cell of low quality is replaced by the star of
a new vertex \cgalCite{cgal:ks-atmi-07}. The set contains the cell, and its boundary is visible
from the barycenter of the cell. Among these sets, the one is chosen for which the worst quality of
the star of the barycenter is highest. The new vertex then moves to a local maximum of this quality,
as in `propose_optimal_position()`, and the best set for the new position is found. This is repeated
while the quality rises.

In 2D, a needle that flips and smoothing cannot remove gets a vertex at its barycenter (section 3.1
of the paper), if this improves the mesh. The split into triangles with even smaller angles and the
following flips are a single change.

Constant time, since the number of cells is bounded; quadratic in their number.

\param complex the complex; it is not changed
\param cell the cell of low quality
\param cavity filled with the proposal if there is one; its last vertex is the new one
\return whether the worst quality rises and all new cells are positively oriented. The replaced
        cells are finite and of one label. There are at most 64 of them, at most 6 steps from the
        given cell. All other vertices keep some of their cells. The interface and the boundary of
        the domain are unchanged.
*/
template <class Complex>
bool propose_vertex_insertion(const Complex& complex, typename Complex::Cell_handle cell,
                              Deformable_simplicial_complexes::Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to move a vertex to a local maximum of the worst quality of its star (optimization-based
smoothing, section 3.2.1 of the paper, after \cgalCite{cgal:fjp-epams-95}). This is an order of
magnitude more expensive than `propose_smart_laplacian()`. Linear in the star.

\param complex the complex; it is not changed
\param v a vertex that is not on the boundary of the domain. If the interface around it is flat, it
       stays in the plane. If the facets around it have a line in common, such as a straight edge
       between two planes or a straight triple line, it stays on the line. Other vertices of the
       interface do not move.
\param star the star of v
\param target the proposed position
\return whether there is a proposal; commit with `complex.set_point(v, star, target)`. The interface
        moves by less than a ten-millionth of the displacement of the vertex, which is the tolerance
        of flatness.
*/
template <class Complex>
bool propose_optimal_position(const Complex& complex, typename Complex::Vertex_handle v,
                              const std::vector<typename Complex::Cell_handle>& star,
                              typename Complex::Point_3& target);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to move a vertex towards the barycenter of its neighbors (smart Laplacian smoothing,
section 3.2 of the paper). The vertex moves to the barycenter, or half of the displacement, if this
raises the worst quality of its star. Linear in the star.

\param complex the complex; it is not changed
\param v a vertex that is not on the interface; a vertex on the boundary of the domain stays within
       its sides
\param star the star of v
\param target the proposed position
\return whether there is a proposal; commit with `complex.set_point(v, star, target)`
*/
template <class Complex>
bool propose_smart_laplacian(const Complex& complex, typename Complex::Vertex_handle v,
                             const std::vector<typename Complex::Cell_handle>& star,
                             typename Complex::Point& target);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes another label for a nearly flat cell trapped between two parts of the interface
("tetrahedron relabeling", section 3.2.1 of the paper). The topology of the interface may change.
Linear in the star of a vertex.

First rule: the largest facet of the cell lies on the interface, and the opposite vertex projects
into the facet. This vertex is on the interface or on the boundary of the domain. The cell then
joins the phase behind the facet. The facet may be smaller than the largest one by 2 % (in 2D, by 1
%). The projection may be outside the facet by a hundredth of its height.

The cell keeps its label if its phase wets the interface between the phase behind the facet and a
phase at the opposite vertex: a thin layer that wets an interface stays.

Second rule, for half the threshold: the cell joins the neighboring phase for which the energy of
the interface decreases most, if there is one.

\param complex the complex; it is not changed
\param cell a finite cell
\param threshold only cells of lower quality are considered; the paper uses 0.01
\param label the proposed label
\param energy the energy of the interface; energy densities have no effect. The default is the
       measure.
\return whether there is a proposal; commit it with `complex.relabel(cell, label)`
\throws Error if a tension is out of its range
*/
template <class Complex>
bool propose_relabeling(const Complex& complex, typename Complex::Cell_handle cell,
                        double threshold, typename Complex::Label& label,
                        const Interface_energy& energy);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns whether giving a cell another label keeps the topology of the two labels, both for the union
of their closed cells and for its interior. The topology of the interface then also stays. All Betti
numbers stay the same; other labels are not affected. Linear in the stars of the vertices of the
cell.

Four sets change: the cell leaves the closed cells of its old label and joins those of the new
label; it joins the closed complement of the old label and leaves that of the new label. A set keeps
its homotopy type if the set without the cell meets the boundary of the cell in a contractible set.
This is the criterion for simple points in digital topology, applied to simplices. At the boundary
of the domain, the same must hold for the sets together with the outside.

\param complex the complex; it is not changed
\param cell a finite cell
\param label the new label, different from that of the cell
\return whether the topology stays. The result depends only on incidences. Changes that cancel each
        other count as changes, such as one part that is cut off while another one joins.
*/
template <class Complex>
bool relabeling_keeps_topology(const Complex& complex, typename Complex::Cell_handle cell,
                               typename Complex::Label label);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns whether several cells can get another label one after the other, so that each step keeps the
topology as defined above. Quadratic in the number of cells if the given order is valid, otherwise
cubic.

\param complex the complex; it is not changed
\param cells finite cells, each once
\param label the new label, different from those of the cells
\return whether an order was found. The search is greedy, without backtracking, so that it misses an
        order in rare cases; the result is then false although the topology would stay.
*/
template <class Complex>
bool relabeling_keeps_topology(const Complex& complex,
                               std::vector<typename Complex::Cell_handle> cells,
                               typename Complex::Label label);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to flip an edge between two triangles of one label. They are replaced by the two triangles
on both sides of the other diagonal of their quadrilateral. Constant time.

\param complex the complex; it is not changed
\param cell, i the edge opposite to the vertex i of a finite triangle
\param cavity filled with the proposal if there is one
\return whether both new triangles are positively oriented and the worst quality rises
*/
template <class Complex>
bool propose_edge_flip(const Complex& complex, typename Complex::Cell_handle cell, int i,
                       Deformable_simplicial_complexes::Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to exchange neighbors (T1 event). The phases on both sides of a short wall are separated,
and the two phases at its ends become neighbors. The wall is one edge of the interface between two
vertices where three phases meet. It is replaced by a wall perpendicular to it. A wall may also end
at a side of a box. Then the phase at its other end reaches this side, and there is no new wall.
Linear in the stars of the two vertices, but quadratic in the phases at the ends.

\param complex the complex; it is not changed
\param cell, i the edge opposite to the vertex i of a finite triangle
\param longest largest length of walls to be considered, divided by the mean length of the four
       other interface edges at the ends of the wall
\param cavity filled with the proposal if there is one; the ends of the wall move. If the wall ends
       at a side, a new vertex on this side replaces its inner end.
\param energy the energy of the interface; energy densities have no effect. The default is the
       length.
\return the exchange, if it decreases the energy of the interface, all new triangles are positively
        oriented, and `complex.keeps_quality()` holds
\throws Error if a tension is out of its range
*/
template <class Complex>
std::optional<Neighbor_exchange<Complex>>
propose_neighbor_exchange(const Complex& complex, typename Complex::Cell_handle cell, int i,
                          double longest, Deformable_simplicial_complexes::Cavity<Complex>& cavity,
                          const Interface_energy& energy);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to remove an edge (section 3.2.1 of the paper). The ring of n cells around the edge is
replaced by 2 (n - 2) tetrahedra, over and under a triangulation of the ring polygon. The
triangulation maximizes the worst quality, by the dynamic program of \cgalCite{cgal:k-mtpd-80}. The
3-2 flip and the 4-4 flip are the cases n = 3 and n = 4. Cubic in n.

\param complex the complex; it is not changed
\param cell, i, j the edge between the vertices i and j of the cell
\param cavity filled with the proposal if there is one
\return whether the ring is finite, of one label and of at most 52 cells, the worst quality rises,
        and all new tetrahedra are positively oriented. The interface and the boundary of the domain
        are unchanged.
*/
template <class Complex>
bool propose_edge_removal(const Complex& complex, typename Complex::Cell_handle cell, int i, int j,
                          Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to flip an edge of the interface (section 3.2.2 of the paper). The two facets that share
the edge are replaced by the two facets that share the other diagonal of their quadrilateral. This
is edge removal with the diagonal as a constraint. The interface moves by the tetrahedron of the
four vertices; the caller must decide whether this is acceptable. Cubic in the number of cells
around the edge.

\param complex the complex; it is not changed
\param cell, i, j the edge between the vertices i and j of the cell
\param cavity filled with the proposal if there is one
\param minimum_quality if all new tetrahedra are better than this, the worst quality need not rise;
       by default 1, which no tetrahedron exceeds
\return whether the proposal is valid: the ring is finite and of at most 52 cells, and exactly two
        facets of the interface meet in the edge. The worst quality rises or is above
        `minimum_quality`, and all new tetrahedra are positively oriented. The topology of the
        interface stays.
*/
template <class Complex>
bool propose_interface_edge_flip(const Complex& complex, typename Complex::Cell_handle cell, int i,
                                 int j, Cavity<Complex>& cavity, double minimum_quality);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to remove a facet together with neighboring facets that are sandwiched between the same two
vertices a and b (section 3.2.1 of the paper). If there are m facets, their 2m cells are replaced by
m + 2 cells that share the new edge ab. The 2-3 flip is the case m = 1. A recursion
\cgalCite{cgal:s-tdoat-02} finds the set of facets that raises the worst quality most. Linear in m.

\param complex the complex; it is not changed
\param cell, i the facet
\param cavity filled with the proposal if there is one
\return whether the two cells of the facet are finite and of one label, the worst quality rises, and
        all new tetrahedra are positively oriented. The interface and the boundary of the domain are
        unchanged.
*/
template <class Complex>
bool propose_multi_face_removal(const Complex& complex, typename Complex::Cell_handle cell, int i,
                                Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to retriangulate the facets that are sandwiched between the same two vertices as a given
facet. The set is the largest one that is connected through edges inside one label. Its m facets are
replaced by the triangulation of its boundary loop that maximizes the worst quality, so that 2m
cells become 2m others. The operation combines multi-face removal and removal of the new edge, and
does not require that the mesh improves in between \cgalCite{cgal:mbae-tmium-09}. Cubic in m.

\param complex the complex; it is not changed
\param cell, i the facet
\param cavity filled with the proposal if there is one
\return whether the proposal is valid: the two cells of the facet are finite and of one label, and
        the set is a disk without inner vertices with at most 50 facets. The worst quality rises,
        and all new tetrahedra are positively oriented. The interface and the boundary of the domain
        are unchanged.
*/
template <class Complex>
bool propose_multi_face_retriangulation(const Complex& complex, typename Complex::Cell_handle cell,
                                        int i, Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to flip the longest edge of a cap if the edge is on the interface. The interface is
flipped, too: both new triangles get the label of the other side of the edge. The two edges at the
tip of the cap, which must be on the interface, take the place of the flipped edge. Linear in the
stars of the vertices. Section 3.1 of the paper.

\param complex the complex; it is not changed
\param cell, i the edge opposite to the vertex i, the tip, of a finite triangle
\param cavity filled with the proposal if there is one
\return whether the proposal is valid: the edge and the tip are on the interface, and the topology
        stays. Both new triangles are positively oriented, and the worst quality rises. The
        interface moves by the area of the cap.
*/
template <class Complex>
bool propose_cap_flip(const Complex& complex, typename Complex::Cell_handle cell, int i,
                      Deformable_simplicial_complexes::Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to remove a triangle with a small angle. Of a *cap*, a triangle with an obtuse angle, the
longest edge is flipped, with `propose_cap_flip()` if it is on the interface. If this is not
possible, or if the triangle is a *needle*, the shortest edge is collapsed. Section 3.1 of the
paper. The complexity is that of these functions.

\param complex the complex; it is not changed
\param cell a triangle
\param cosine only triangles with an angle of larger cosine are considered. The paper uses 0.99 for
       minus the cosine of the obtuse angle of a cap, and an angle of 0.01 &pi; for needles.
\param minimum_quality lower bound of the quality of the new triangles of a collapse
\param cavity filled with the proposal if there is one
\return whether the triangle is finite, has a small angle, and there is a proposal. The topology of
        the interface stays. The interface is unchanged, or moves by the triangles that are
        replaced.
*/
template <class Complex>
bool propose_degenerate_triangle_removal(const Complex& complex, typename Complex::Cell_handle cell,
                                         double cosine, double minimum_quality,
                                         Deformable_simplicial_complexes::Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to remove a facet with a small angle. Of a *cap*, the longest edge is removed, or flipped
if the facet is on the interface. Of a *needle*, the shortest edge is collapsed. A facet is a cap if
its largest angle is above 120 degrees and its longest edge is 1.03 times as long as the second one.
For facets with the smallest angle of the paper, the lengths alone decide, as in the paper. Section
3.2.1 of the paper, degeneracy removal (b). The complexity is that of the functions below.

\param complex the complex; it is not changed
\param cell, i a finite facet
\param cosine only facets with an angle of larger cosine are considered; the paper uses 0.999
\param minimum_quality lower bound of the quality of the new tetrahedra of a collapse
\param cavity filled with the proposal if there is one
\return whether the facet has a small angle, and `propose_edge_removal()`,
        `propose_interface_edge_flip()` or `propose_edge_collapse()` makes the proposal described
        above. The interface is unchanged, or moves by the volume next to its nearly flat facets.
*/
template <class Complex>
bool propose_degenerate_facet_removal(const Complex& complex, typename Complex::Cell_handle cell,
                                      int i, double cosine, double minimum_quality,
                                      Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Proposes to remove a nearly flat cell (section 3.2.1 of the paper, degeneracy removal (a)). The
operation depends on the projection of the apex, which is the vertex opposite to the largest facet.
If the cell were pressed flat, it would become

- *three facets* around the apex if it projects into the largest facet, which is removed;
- *two facets* if the apex projects to an edge of the largest facet, within a tenth of the height of
  the facet; this edge is removed;
- *four facets* if the apex projects beyond an edge: this edge and the opposite edge of the cell
  cross. One of them is removed, the one whose removal gives the better worst quality;
- *one facet* if the apex projects to a vertex, within a tenth of the height; the edge between the
  apex and this vertex is collapsed.

These are all cases, since the facet is the largest one. The complexity is that of the functions
below.

\param complex the complex; it is not changed
\param cell the cell
\param threshold only cells of lower quality are considered; the paper uses 0.005. It is also the
       lower bound of the quality of the new tetrahedra of a collapse.
\param cavity filled with the proposal if there is one
\return whether the cell is finite and nearly flat, and `propose_multi_face_removal()`,
        `propose_edge_removal()` or `propose_edge_collapse()` makes the proposal described above. If
        two facets of the cell at the edge are on the interface, `propose_interface_edge_flip()`
        makes the proposal. The topology of the interface stays. The interface is unchanged, or
        moves by the cell. Cells whose removal changes more are left to `propose_relabeling()`.
*/
template <class Complex>
bool propose_degenerate_tetrahedron_removal(const Complex& complex,
                                            typename Complex::Cell_handle cell, double threshold,
                                            Cavity<Complex>& cavity);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Commits a cavity by `Complex::replace()`, and calls a visitor before and after the replacement. The
functions below also call the functions of the visitor for each kind of proposal. n log n in the
size of the cavity, plus the costs of `Complex::replace()` for components.

\param complex the complex
\param cavity the proposal
\param visitor the visitor
\pre See `Complex::replace()`.
\throws Stale_proposal_error if the complex has changed since the cavity was begun; the complex is
        then unchanged, but `before_replacement()` was called. If a function of the visitor throws
        before the replacement, the complex is unchanged. If one throws after the replacement, the
        complex is valid.
*/
template <class Complex>
void replace_cavity(Complex& complex, Cavity<Complex>& cavity,
                    Deformation_visitor<Complex>& visitor);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Moves a vertex to a target by `Complex::set_point()`, and calls a visitor before and after the
motion. Linear in the star.

\param complex the complex
\param v a finite vertex
\param star the star of `v`
\param target the target, which is rounded
\param visitor the visitor. If it throws before the motion, the complex is unchanged. If it throws
       after the motion, the complex is valid.
\pre `complex.is_positive_star(v, star, target)`
*/
template <class Complex>
void smooth_vertex(Complex& complex, typename Complex::Vertex_handle v,
                   const std::vector<typename Complex::Cell_handle>& star,
                   const typename Complex::Point& target, Deformation_visitor<Complex>& visitor);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Updates the spacing of a vertex into which a vertex of the interface was collapsed. The spacing
becomes the mean length of the edges of the interface at the vertex if this is greater. A smaller
length does not count, because the interface can have shrunk. A vertex without spacing stays so.
Linear in the star. `commit_proposal()` calls this function.
*/
template <class Complex>
void coarsen_spacing(const Complex& complex, typename Complex::Vertex_handle kept);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Commits the split of an edge, calls the visitor, and counts the split in a report. If the edge is on
the interface, its ends and the new vertex get a new spacing.

\param complex the complex
\param cavity a proposal of `propose_edge_split()` for the edge; the new vertex is its last one
\param v, w the ends of the edge
\param visitor the visitor; `after_split()` is called last
\param report `report.split` is increased after the replacement
\pre `cavity.kind()` is `Proposal_kind::split`.
\throws Stale_proposal_error as `replace_cavity()`
*/
template <class Complex>
void commit_split(Complex& complex, Cavity<Complex>& cavity, typename Complex::Vertex_handle v,
                  typename Complex::Vertex_handle w, Deformation_visitor<Complex>& visitor,
                  Improvement_report& report);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Commits a collapse, an insertion or a flip, calls the visitor, and counts the operation in a report.

\param complex the complex
\param cavity the proposal
\param visitor the visitor; `before_collapse()` is called first, `after_insertion()` or
       `after_flip()` is called last
\param report the number of operations of this kind is increased after the replacement
\pre `cavity.kind()` is `Proposal_kind::collapse`, `insertion` or `flip`. Use `commit_split()` for a
     split, and `replace_cavity()` for any other replacement.
\throws Stale_proposal_error as `replace_cavity()`
*/
template <class Complex>
void commit_proposal(Complex& complex, Cavity<Complex>& cavity,
                     Deformation_visitor<Complex>& visitor, Improvement_report& report);

/*!
\ingroup PkgDeformableSimplicialComplexesRef

Returns whether a proposal moves only a small volume from one label to another, as the operations of
`deform_interface()` do. The bound is three percent of the volume that each label has in the cells
around the operation. It is smaller where a label is thin relative to the edges of the interface.
Linear in the number of these cells.

\param complex the complex
\param cavity a proposal that collapses an edge or, in space, flips an edge of the interface. For
       other proposals, the function returns `true` without a test.
*/
template <class Complex> bool keeps_volumes(const Complex& complex, const Cavity<Complex>& cavity);

} // namespace CGAL::Deformable_simplicial_complexes

#endif // CGAL_DEFORMABLE_SIMPLICIAL_COMPLEXES_MESH_OPERATIONS_H
