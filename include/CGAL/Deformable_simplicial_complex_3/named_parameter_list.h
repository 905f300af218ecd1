// List of the package's named parameters, in the format of CGAL's own list:
// CGAL_add_named_parameter(tag type, tag, function). No include guard: included several times.

// clang-format off
CGAL_add_named_parameter(normalize_t, normalize, normalize)
CGAL_add_named_parameter(enclosing_box_t, enclosing_box, enclosing_box)
CGAL_add_named_parameter(box_subdivision_t, box_subdivision, box_subdivision)
CGAL_add_named_parameter(improve_t, improve, improve)
CGAL_add_named_parameter(quality_threshold_t, quality_threshold, quality_threshold)
CGAL_add_named_parameter(relabeling_threshold_t, relabeling_threshold, relabeling_threshold)
CGAL_add_named_parameter(maximum_number_of_passes_t, maximum_number_of_passes, maximum_number_of_passes)
CGAL_add_named_parameter(scheme_t, scheme, scheme)
CGAL_add_named_parameter(number_of_threads_t, number_of_threads, number_of_threads)
CGAL_add_named_parameter(topology_control_t, topology_control, topology_control)
CGAL_add_named_parameter(manifold_interface_t, manifold_interface, manifold_interface)
CGAL_add_named_parameter(aggressive_t, aggressive, aggressive)
