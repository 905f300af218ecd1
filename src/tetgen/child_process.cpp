// Copyright (c) 2026 The deformable simplicial complex authors
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "child_process.h"

#include <CGAL/Mesh_support/Progress_scope.h>

#include <algorithm>

#ifdef DSC_HAS_FORK
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#endif

namespace CGAL::Deformable_simplicial_complexes::internal {

#ifdef DSC_HAS_FORK

namespace {

// Number of bytes sent or received at once: the pipe capacity of most systems.
constexpr std::size_t buffer_size = std::size_t(1) << 16;

// Maximum time limit in seconds, about three years. Some systems reject timers of more than 1e8
// seconds.
constexpr double longest_time = 9e7;

class File_descriptor
{
public:
  explicit File_descriptor(int value) : m_value(value) {}
  ~File_descriptor() {
    if (m_value >= 0)
      close(m_value);
  }
  File_descriptor(const File_descriptor&) = delete;
  File_descriptor& operator=(const File_descriptor&) = delete;

  int get() const { return m_value; }
  int release() { return std::exchange(m_value, -1); }

private:
  int m_value;
};

std::system_error system_error(int code) {
  return std::system_error(code, std::generic_category(), "no child process");
}

// Opens a pipe whose ends are not inherited by programs that other threads start.
void open_pipe(int (&ends)[2]) {
#ifdef __APPLE__
  if (pipe(ends) != 0)
    throw system_error(errno);
  for (int end : ends)
    fcntl(end, F_SETFD, FD_CLOEXEC);
#else
  if (pipe2(ends, O_CLOEXEC) != 0)
    throw system_error(errno);
#endif
}

// The functions from here to run() are executed by the child.

void be_silent() {
  const int nowhere = open("/dev/null", O_WRONLY);
  dup2(nowhere, STDOUT_FILENO);
  dup2(nowhere, STDERR_FILENO);
  const rlimit no_core_dump = {0, 0};
  setrlimit(RLIMIT_CORE, &no_core_dump);
}

// Ignores signals such as the one of Ctrl-C, which both processes get: the caller must handle them.
// Signals of crashes still end the child.
void ignore_what_the_caller_handles() {
  for (int number = 1; number < NSIG; ++number) {
    struct sigaction action;
    if (sigaction(number, nullptr, &action) == 0 && action.sa_handler != SIG_DFL)
      signal(number, SIG_IGN);
  }
  for (int crash : {SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGSEGV})
    signal(crash, SIG_DFL);
}

pid_t caller = 0;

extern "C" void exit_without_caller(int) {
  if (getppid() != caller)
    std::_Exit(EXIT_FAILURE);
}

// Ends the child if the caller was killed, because nobody reads the result. Checks once per second
// of processor time.
void watch_caller() {
  struct sigaction action = {};
  action.sa_handler = exit_without_caller;
  sigemptyset(&action.sa_mask);
  action.sa_flags = SA_RESTART;
  sigaction(SIGVTALRM, &action, nullptr);
  const itimerval each_second = {{1, 0}, {1, 0}};
  setitimer(ITIMER_VIRTUAL, &each_second, nullptr);
}

void limit_time(double seconds) {
  signal(SIGALRM, SIG_DFL);
  seconds = std::clamp(seconds, 0., longest_time);
  const double whole = std::floor(seconds);
  // A timer of zero seconds would be disabled, and a million microseconds are an error.
  const suseconds_t microseconds = suseconds_t((seconds - whole) * 999998) + 1;
  const itimerval once = {{0, 0}, {time_t(whole), microseconds}};
  setitimer(ITIMER_REAL, &once, nullptr);
}

void limit_processor_time(double seconds) {
  signal(SIGXCPU, SIG_DFL);
  rlimit limit;
  if (!(seconds < longest_time) || getrlimit(RLIMIT_CPU, &limit) != 0)
    return;
  limit.rlim_cur = (std::min)(limit.rlim_cur, rlim_t(std::ceil(seconds)));
  setrlimit(RLIMIT_CPU, &limit);
}

void allow_signals() {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
}

[[noreturn]] void exit_with_thrown_code() {
  try {
    if (std::current_exception())
      throw;
  } catch (int code) {
    std::_Exit(code);
  } catch (...) {
  }
  std::abort();
}

void send(int pipe, const char* data, std::size_t size) {
  while (size > 0) {
    const ssize_t sent = ::write(pipe, data, (std::min)(size, buffer_size));
    if (sent >= 0) {
      data += sent;
      size -= std::size_t(sent);
    } else if (errno != EINTR)
      std::abort();
  }
}

[[noreturn]] void run(const Child_process::Function& function, int pipe, double seconds,
                      double processor_seconds) {
  // If the caller has closed its standard streams, the pipe may use one of their numbers.
  pipe = fcntl(pipe, F_DUPFD, STDERR_FILENO + 1);
  be_silent();
  ignore_what_the_caller_handles();
  watch_caller();
  limit_time(seconds);
  limit_processor_time(processor_seconds);
  allow_signals();
  std::set_terminate(exit_with_thrown_code);
  function([pipe](const void* data, std::size_t size) {
    send(pipe, static_cast<const char*>(data), size);
  });
  std::_Exit(EXIT_SUCCESS);
}

} // namespace

Child_process::Child_process(const Function& function, double seconds, double processor_seconds) {
  // Children are started one after the other. A pipe ends only when all its write ends are closed,
  // and other children could inherit them.
  static std::mutex mutex;
  const std::lock_guard<std::mutex> lock(mutex);
  int ends[2];
  open_pipe(ends);
  File_descriptor reader(ends[0]), writer(ends[1]);

  // The function runs on a new stack, without exception handlers of the caller. So std::terminate()
  // is called at the place where an exception is thrown.
  int error = 0;
  std::thread([&] {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_BLOCK, &all, nullptr);
    caller = getpid();
    m_pid = fork();
    if (m_pid == 0) {
      close(reader.get()); // otherwise the pipe would keep an open read end
      run(function, writer.get(), seconds, processor_seconds);
    }
    error = errno;
  }).join();
  if (m_pid < 0)
    throw system_error(error);
  m_pipe = reader.release();
}

Child_process::~Child_process() {
  if (m_pid > 0) {
    kill(m_pid, SIGKILL);
    wait();
  }
}

bool Child_process::refill() {
  // Waits with a timeout, so that the caller can be interrupted before data arrives.
  static constexpr int patience = 50; // milliseconds
  pollfd pipe = {m_pipe, POLLIN, 0};
  int number_of_ready;
  do {
    Progress_scope::check();
    number_of_ready = poll(&pipe, 1, patience);
  } while (number_of_ready == 0 || (number_of_ready < 0 && errno == EINTR));
  m_data.resize(buffer_size);
  m_position = 0;
  ssize_t got;
  do
    got = ::read(m_pipe, m_data.data(), m_data.size());
  while (got < 0 && errno == EINTR);
  m_data.resize(got > 0 ? std::size_t(got) : 0);
  return got > 0;
}

Child_process::Outcome Child_process::wait() {
  close(m_pipe);
  int status = 0;
  while (waitpid(m_pid, &status, 0) < 0 && errno == EINTR) {
  }
  m_pid = 0;
  if (!WIFSIGNALED(status))
    return {End::EXITED, WEXITSTATUS(status)};
  switch (const int number = WTERMSIG(status)) {
  case SIGALRM:
  case SIGXCPU:
    return {End::TIMED_OUT, number};
  case SIGKILL:
    return {End::KILLED, number};
  default:
    return {End::CRASHED, number};
  }
}

#else

Child_process::Child_process(const Function& function, double, double) {
  try {
    function([this](const void* data, std::size_t size) {
      const char* bytes = static_cast<const char*>(data);
      m_data.insert(m_data.end(), bytes, bytes + size);
    });
  } catch (int code) {
    m_outcome.code = code;
  }
}

Child_process::~Child_process() {}

bool Child_process::refill() { return false; }

Child_process::Outcome Child_process::wait() { return m_outcome; }

#endif

bool Child_process::read(void* data, std::size_t size) {
  char* next = static_cast<char*>(data);
  while (size > 0) {
    if (m_position == m_data.size() && !refill())
      return false;
    const std::size_t piece = (std::min)(size, m_data.size() - m_position);
    std::copy_n(m_data.data() + m_position, piece, next);
    m_position += piece;
    next += piece;
    size -= piece;
  }
  return true;
}

} // namespace CGAL::Deformable_simplicial_complexes::internal
