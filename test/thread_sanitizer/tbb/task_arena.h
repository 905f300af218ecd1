#ifndef DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_THREAD_SANITIZER_TBB_TASK_ARENA_H
#define DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_THREAD_SANITIZER_TBB_TASK_ARENA_H

// Replacement of TBB, see parallel_for.h; there are always two threads.
namespace tbb {

class task_arena
{
public:
  bool is_active() const { return true; }
  void initialize(int) {}
  template <class Function> void execute(const Function& function) { function(); }
};

} // namespace tbb

#endif // DEFORMABLE_SIMPLICIAL_COMPLEX_3_TEST_THREAD_SANITIZER_TBB_TASK_ARENA_H
