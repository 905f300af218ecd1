// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "commands/commands.h"
#include "fluids/fluid_fields.h"
#include "fluids/fluid_picture.h"
#include "fluids/fluid_processes.h"
#include "fluids/fluid_report.h"
#include "fluids/fluid_run.h"
#include "fluids/fluid_scene.h"
#include "fluids/fluid_start.h"
#include "input/files.h"
#include "input/formats.h"
#include "input/translations.h"
#include "output/label_titles.h"
#include "output/output_folder.h"
#include "output/progress_line.h"
#include "output/report_json.h"
#include "programs/add_value.h"
#include "programs/errors.h"
#include "programs/interrupt.h"
#include "programs/option_values.h"
#include "programs/standard_streams.h"

#include <CGAL/Mesh_files/checkpoint.h>

#include <climits>

#include <iostream>

namespace dsc {
namespace {

constexpr char built_in_solver[] = "built-in";

struct Fluid_options
{
  std::string scene;   ///< file, or name of an installed scene; empty if `resume` is set
  std::string data;    ///< folder of the files named by a scene; empty for the current folder
  bool lists = false;  ///< whether the installed scenes are listed
  bool prints = false; ///< whether the scene is printed
  double end = 0;      ///< final time; if 0, the end of the scene
  unsigned steps = 0;  ///< maximum number; 0 for no limit
  unsigned threads = (std::max)(1u, default_number_of_threads() / processes_of_machine());
  std::string solver = built_in_solver;
  std::string output; ///< output folder; empty for no files
  unsigned every = 1;
  int subdivisions = 0; ///< of the smooth surfaces in the output, by Loop's scheme; 0 for none
  std::string resume;   ///< checkpoint file
  std::string report;   ///< file; empty for none
  Fluid_picture picture;
  bool quiet = false;

  bool uses_petsc() const { return solver != built_in_solver; }
};

template <int dimension>
void print_summary(const Fluid_run<dimension>& run, unsigned steps, const Repetitions& repetitions,
                   const std::string& range, double seconds) {
  const auto balance = run.fluid->balance();
  std::printf("dsc: %s; %u %s, time %g: %zu vertices, %zu interface %s, %s %.10g, energy %.6g%s%s; "
              "%.3g s\n",
              run.scene.title.c_str(), steps, noun(steps, "step", "steps"), run.fluid->time(),
              run.complex->complex.number_of_vertices(),
              run.complex->complex.interface_facets().size(),
              dimension == 2 ? "edges" : "triangles", dimension == 2 ? "area" : "volume",
              balance.volume, balance.energy(), range.c_str(), repetitions.text().c_str(), seconds);
}

/// Checks that the cut of a picture intersects cells in the domain of a scene, and that the scene
/// has the quantity of the picture.
/// \throws Usage_error
void require_contents(const Fluid_picture& picture, const Fluid_scene& scene) {
  if (const auto& cut = picture.cut)
    if (!(scene.domain[cut->axis] < cut->value && cut->value <= scene.domain[cut->axis + 3]))
      throw Usage_error("--cut is outside the domain; choose a coordinate greater than " +
                        Json(scene.domain[cut->axis]).dump() + " and at most " +
                        Json(scene.domain[cut->axis + 3]).dump());
  if (picture.quantity == "field" && !scene.field)
    throw Usage_error(
        "--color field applies only to a scene with a field; choose another quantity");
}

/// A run with its output files and messages.
template <int dimension> class Reported_run
{
public:
  using Complex = typename Fluid_run<dimension>::Complex;

  /// \param scene the scene, unless the run is resumed
  Reported_run(const Fluid_options& options, std::optional<Fluid_scene> scene)
      : m_options(options), m_scene(std::move(scene)) {}

  /// Checks whether the output files can be written.
  /// \throws Usage_error, Input_error
  void check_places();

  /// Builds or reads the complex.
  void begin();

  /// Writes the initial state, does the steps until the end or an interrupt, and writes the result.
  void do_steps();

  /// Prints the result; after an interrupt, writes it. Returns the exit code.
  int finish();

private:
  void advance();
  bool is_over() const;
  unsigned step() const { return m_first + m_done; }
  void write_files();
  void write_report() const;
  std::string save(const char* name);

  const Fluid_options& m_options;
  std::optional<Fluid_scene> m_scene; // empty if the run is resumed
  std::optional<Output_folder> m_folder;
  const Clock::time_point m_begin = Clock::now();
  Fluid_run<dimension> m_run;
  double m_end = 0; // time
  Json m_steps = Json::array();
  Repetitions m_repetitions;
  std::vector<std::string> m_vanished; // labels
  std::string m_range;                 // of the colors of the picture
  unsigned m_first = 0, m_done = 0;    // numbers of steps
  bool m_is_stopped = false;           // by an interrupt
};

template <int dimension> void Reported_run<dimension>::check_places() {
  if (dimension == 2 && m_options.subdivisions > 0)
    throw Usage_error("--subdivide applies only in space; leave it out");
  if (dimension == 2 && m_options.picture.cut)
    throw Usage_error("--cut applies only in space; leave it out");
  if (dimension == 3 && !m_options.picture.cut && !m_options.picture.quantity.empty())
    throw Usage_error("--color needs a --cut in space, like --cut x=0.5");
  if (!m_options.picture.path.empty())
    require_format(m_options.picture.path, Use::write,
                   dimension == 2 ? content::drawing : content::picture);
  if (m_scene)
    require_contents(m_options.picture, *m_scene);
  if (!m_options.output.empty())
    m_folder.emplace(m_options.output, m_options.subdivisions).claim(m_options.resume);
  require_place("--report", m_options.report, {m_options.resume, m_options.scene});
  require_place("--picture", m_options.picture.path,
                {m_options.resume, m_options.scene, m_options.report});
}

template <int dimension> void Reported_run<dimension>::begin() {
  const Interruptible interruptible(m_options.quiet);
  m_run = m_scene
              ? start_fluid<dimension>(*m_scene, m_options.data, m_options.threads, m_options.quiet,
                                       m_options.uses_petsc())
              : resume_fluid<dimension>(m_options.resume, m_options.data, m_options.uses_petsc());
  Fluid<Complex>& fluid = *m_run.fluid;
  m_run.complex->arrays = {[&fluid] { return cell_arrays<Complex>(fluid); },
                           [&fluid] { return interface_arrays<Complex>(fluid); }};
  if (!m_scene)
    require_contents(m_options.picture, m_run.scene);
  m_end = m_options.end > 0 ? m_options.end : m_run.scene.end;
  if (!(m_end > fluid.time()))
    throw Usage_error("the final time " + Json(m_end).dump() + " is not after the time " +
                      Json(fluid.time()).dump() + " of the checkpoint; choose a later --end");
  if (m_folder && !m_options.resume.empty())
    m_folder->keep_until(fluid.time());
  m_first = unsigned(fluid.state().steps);
  m_steps.push_back(step_json<Complex>(fluid, m_run.scene, m_first, std::nullopt));
}

template <int dimension> void Reported_run<dimension>::write_files() {
  if (!m_folder)
    return;
  const Run_position position = {step(), m_run.fluid->time(), {}};
  m_folder->save(*m_run.complex, position, m_run.metadata());
  m_folder->write(*m_run.complex, position);
}

/// Saves the run in the first of several processes, see save_run().
template <int dimension> std::string Reported_run<dimension>::save(const char* name) {
  if (!is_first_process())
    return name;
  return save_run(m_folder, name, *m_run.complex, {step(), m_run.fluid->time(), {}},
                  m_run.metadata());
}

template <int dimension> void Reported_run<dimension>::write_report() const {
  if (!m_options.report.empty())
    write_json(
        m_options.report,
        {{"scene", m_run.scene.json}, {"repeated", m_repetitions.json()}, {"steps", m_steps}});
}

template <int dimension> bool Reported_run<dimension>::is_over() const {
  return m_run.fluid->time() >= m_end || (m_options.steps > 0 && m_done >= m_options.steps) ||
         interrupted();
}

template <int dimension> void Reported_run<dimension>::advance() {
  Fluid<Complex>& fluid = *m_run.fluid;
  typename Fluid<Complex>::Options options;
  options.deformation.number_of_threads = m_options.threads;
  options.implicitness = m_run.scene.implicitness;
  options.interface_tolerance = m_run.scene.interface_tolerance;
  options.adaptation_interval = unsigned(m_run.scene.adaptation_interval);
  const double dt = m_run.next_step(m_end);
  const auto report = [&] {
    try {
      set_time(m_run.scene, fluid.time() + dt / 2, fluid);
      return fluid.advance(dt, options); // all or nothing
    } catch (const DSC::Interrupted_error&) {
      throw;
    } catch (const DSC::Fluid_step_error&) {
      throw;
    } catch (const std::exception& error) {
      throw std::runtime_error("step " + std::to_string(step() + 1) + " of the fluid at time " +
                               Json(fluid.time()).dump() + " failed: " + error_message(error));
    }
  }();
  set_time(m_run.scene, fluid.time(), fluid);
  ++m_done;
  m_steps.push_back(step_json<Complex>(fluid, m_run.scene, step(), report));
  m_repetitions.add(report.repetitions);
  for (const auto& event : report.deformation.events)
    if (event.after.empty() && m_run.complex->complex.number_of_components(event.label) == 0)
      m_vanished.push_back(label_title(event.label, m_run.scene.names) + " (step " +
                           std::to_string(step()) + ")");
  if (fluid.volumes().empty())
    throw std::runtime_error("no liquid remains after step " + std::to_string(step()) +
                             "; choose a smaller edge length or time step");
}

template <int dimension> void Reported_run<dimension>::do_steps() {
  static constexpr unsigned parts = 100; // of the simulated time
  Progress_line progress(parts, m_options.quiet, "progress");
  const Fluid<Complex>& fluid = *m_run.fluid;
  const double start_time = fluid.time();
  try {
    std::optional<Interruptible> scope(true);
    write_files();
    while (!is_over()) {
      advance();
      progress.show(unsigned(parts * (fluid.time() - start_time) / (m_end - start_time)));
      if (step() % m_options.every == 0)
        write_files();
    }
    progress.clear();
    if (!interrupted())
      write_files();
    m_is_stopped = interrupted();
    scope.reset();
    if (!m_is_stopped) {
      write_report();
      if (!m_options.picture.path.empty())
        m_range = draw_fluid<dimension>(m_options.picture, *m_run.complex, *m_run.fluid);
      if (m_folder)
        m_folder->require(*m_run.complex);
    }
  } catch (const DSC::Interrupted_error&) {
    m_is_stopped = true;
    progress.clear();
  } catch (const std::exception& error) {
    progress.clear();
    all_processes_fail(); // they wait while the first one writes
    throw std::runtime_error(message_after_saving(
        error, step(), [&] { return m_folder || m_done > 0 ? save("dsc_failed") : std::string(); },
        [&] { write_report(); }));
  }
}

template <int dimension> int Reported_run<dimension>::finish() {
  if (m_is_stopped) {
    std::cerr << "dsc: interrupted after step " << step() << "; continue with dsc fluid --resume "
              << save("dsc_interrupted") << '\n';
    write_report();
  }
  if (!m_options.quiet && !m_vanished.empty())
    std::printf("dsc: %s %s vanished\n", noun(m_vanished.size(), "label", "labels"),
                listed(m_vanished).c_str());
  if (!m_options.quiet)
    print_summary(m_run, m_done, m_repetitions, m_range, seconds_since(m_begin));
  return m_is_stopped ? exit_code_of_interrupt : 0;
}

/// Runs a scene or, without a scene, resumes a checkpoint. Returns the exit code.
template <int dimension>
int run_fluid(const Fluid_options& options, std::optional<Fluid_scene> scene) {
  Reported_run<dimension> run(options, std::move(scene));
  run.check_places(); // fails before the computation starts
  run.begin();
  run.do_steps();
  return run.finish();
}

int execute(const Fluid_options& options) {
  if (options.quiet)
    keep_silent_about_unused();
  if (options.lists) {
    for (const auto& [name, title] : scene_names())
      std::printf("%-16s%s\n", name.c_str(), title.c_str());
    return 0;
  }
  if (options.prints) {
    std::printf("%s\n", find_scene(options.scene).json.dump(2).c_str());
    return 0;
  }
  std::optional<Fluid_scene> scene;
  if (options.resume.empty())
    scene = find_scene(options.scene);
  const int dimension = scene ? scene->dimension : CGAL::IO::checkpoint_dimension(options.resume);
  return dimension == 2 ? run_fluid<2>(options, std::move(scene))
                        : run_fluid<3>(options, std::move(scene));
}

/// Throws if other options are given: scenes are listed or printed without any.
void require_alone(const CLI::App& command, const std::vector<std::string>& names) {
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0 &&
        std::find(names.begin(), names.end(), option->get_name()) == names.end())
      throw Usage_error(option->get_name() + " has no effect with " + names.front() +
                        "; leave it out");
}

void complete(const CLI::App& command, Fluid_options& options) {
  if (options.lists)
    require_alone(command, {"--list"});
  if (options.prints)
    require_alone(command, {"--print", "SCENE"});
  if (!options.picture.path.empty())
    require_format(options.picture.path, Use::write, content::picture | content::drawing);
  if (!options.lists && options.scene.empty() == options.resume.empty())
    throw Usage_error("dsc fluid needs either a SCENE or --resume; see dsc fluid --list for "
                      "scenes");
  if (options.prints && options.scene.empty())
    throw Usage_error("dsc fluid --print needs a SCENE; see dsc fluid --list");
  if (!is_first_process()) { // the first one writes all files
    options.quiet = true;
    options.output.clear();
    options.report.clear();
    options.picture.path.clear();
  }
}

} // namespace

void add_fluid(CLI::App& app, int& exit_code) {
  const auto options = std::make_shared<Fluid_options>();
  CLI::App* command = app.add_subcommand("fluid", description_of_fluid);
  add_input(*command, "SCENE", options->scene,
            "Scene file (.json), or the name of a scene of the program (see --list); - for "
            "standard input");
  command->add_flag("--list", options->lists,
                    "Print the names and titles of the scenes of the program");
  command->add_flag("--print", options->prints, "Print the scene as JSON");
  command->add_option("--data", options->data, "Folder of the files that the scene names");
  add_value(*command, "--end", options->end, positive,
            "Final time (default: final time of the scene)");
  command->add_option("--steps", options->steps, "Maximum number of steps")
      ->check(CLI::Range(1, INT_MAX));
  add_threads_option(*command, options->threads);
  command
      ->add_option("--solver", options->solver,
                   "Solver of the linear systems; petsc runs in parallel with mpirun, and takes "
                   "options of PETSc like -ksp_view")
      ->check(CLI::IsMember({built_in_solver, "petsc"}))
      ->capture_default_str();
  CLI::Option* output =
      command->add_option("--output", options->output,
                          "Folder for ParaView files and a checkpoint; created if necessary");
  command
      ->add_option("--subdivide", options->subdivisions,
                   "Also write the interface of these steps as a smooth surface (.ply), with this "
                   "number of Loop subdivision steps")
      ->check(CLI::Range(1, most_subdivisions))
      ->needs(output);
  command->add_option("--every", options->every, "Write every N-th step")
      ->check(CLI::Range(1, INT_MAX))
      ->needs(output)
      ->capture_default_str();
  add_input(*command, "--resume", options->resume,
            "Continue from a checkpoint; the result is bitwise identical");
  add_output(*command, "--report", options->report,
             "JSON file with energies, momenta, volumes and contacts of each step", "json");
  CLI::Option* picture =
      add_output(*command, "--picture", options->picture.path,
                 "Picture of the liquids at the end (.png in space, .svg in the plane)");
  add_value(*command, "--cut", options->picture.cut, parse_cut,
            "Draw the section by a plane perpendicular to an axis, like x=0.5 (space only)")
      ->needs(picture);
  command
      ->add_option("--color", options->picture.quantity,
                   "Color the liquids in the plane or in the section by this quantity (default: by "
                   "label)")
      ->check(CLI::IsMember(quantities_of_pictures()))
      ->needs(picture);
  command->add_flag("--quiet", options->quiet, "Print only errors");
  command->callback([command, options, &exit_code] {
    complete(*command, *options);
    exit_code = execute(*options);
  });
}

} // namespace dsc
