#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

// Threads for studies whose pieces are studies themselves.
namespace fiberchain::compare {

/// Threads that loops share, loops within pieces of other loops, too: who waits for the last pieces of a loop
/// does pieces of others meanwhile, so that no thread is idle while anything is left to begin.
class Workers {
 public:
  /// `threads` with the one that calls run().
  explicit Workers(int threads);
  ~Workers();
  Workers(const Workers&) = delete;
  Workers& operator=(const Workers&) = delete;

  /// Calls piece(i) for i in [0, count), begun in this order; back when all are done. Each i writes its own
  /// results, so the outcome does not depend on the number of threads. After an exception no more pieces of
  /// this loop are begun; the first one is thrown here. To be called by one thread from outside at a time,
  /// and by pieces.
  void run(std::size_t count, const std::function<void(std::size_t)>& piece);

 private:
  struct Loop {
    std::size_t count;
    const std::function<void(std::size_t)>& piece;
    std::size_t next = 0, at_work = 0;
    std::exception_ptr error = nullptr;

    bool begun() const { return next >= count; }
    bool done() const { return begun() && at_work == 0; }
  };
  using Lock = std::unique_lock<std::mutex>;

  void do_piece(Lock& lock, Loop& loop);
  /// Of the newest loop that has pieces left; false if there is none.
  bool do_any_piece(Lock& lock);
  void serve();

  std::mutex mutex_;
  std::condition_variable changed_;  ///< a loop is new or done, or all is over
  std::vector<Loop*> open_;          ///< loops with pieces left, the newest last
  bool over_ = false;
  std::vector<std::thread> threads_;
};

/// How many threads a study may have, or whose.
class Jobs {
 public:
  /*implicit*/ Jobs(int threads = 1) : threads_(threads) {}
  /*implicit*/ Jobs(Workers& shared) : shared_(&shared) {}

  /// As Workers::run().
  void run(std::size_t count, const std::function<void(std::size_t)>& piece) const;
  /// One piece for each of these costs, begun in the order of dearest_first().
  void run_dearest_first(const std::vector<double>& costs,
                         const std::function<void(std::size_t)>& piece) const;

 private:
  int threads_ = 1;
  Workers* shared_ = nullptr;
};

/// Indices of these costs, the dearest first: begun in this order, no thread is left with one of them alone.
std::vector<std::size_t> dearest_first(const std::vector<double>& costs);

}  // namespace fiberchain::compare
