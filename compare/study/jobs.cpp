#include "compare/study/jobs.hpp"

#include <algorithm>
#include <numeric>
#include <system_error>

namespace fiberchain::compare {

Workers::Workers(int threads) {
  try {
    for (int n = 1; n < threads; ++n) threads_.emplace_back([this] { serve(); });
  } catch (const std::system_error&) {  // the system gives no more: those there are do the work
  }
}

Workers::~Workers() {
  {
    const Lock lock(mutex_);
    over_ = true;
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void Workers::run(std::size_t count, const std::function<void(std::size_t)>& piece) {
  if (count == 0) return;
  Loop loop{.count = count, .piece = piece};
  Lock lock(mutex_);
  open_.push_back(&loop);
  changed_.notify_all();
  while (!loop.done()) {
    if (!loop.begun()) {
      do_piece(lock, loop);
    } else if (!do_any_piece(lock)) {
      changed_.wait(lock);
    }
  }
  if (loop.error) std::rethrow_exception(loop.error);
}

void Workers::do_piece(Lock& lock, Loop& loop) {
  const std::size_t i = loop.next++;
  if (loop.begun()) std::erase(open_, &loop);
  ++loop.at_work;
  lock.unlock();
  std::exception_ptr error;
  try {
    loop.piece(i);
  } catch (...) {
    error = std::current_exception();
  }
  lock.lock();
  if (error && !loop.error) {
    loop.error = error;
    loop.next = loop.count;
    std::erase(open_, &loop);
  }
  --loop.at_work;
  if (loop.done()) changed_.notify_all();
}

bool Workers::do_any_piece(Lock& lock) {
  if (open_.empty()) return false;
  do_piece(lock, *open_.back());
  return true;
}

void Workers::serve() {
  Lock lock(mutex_);
  while (!over_) {
    if (!do_any_piece(lock)) changed_.wait(lock);
  }
}

void Jobs::run(std::size_t count, const std::function<void(std::size_t)>& piece) const {
  if (shared_) return shared_->run(count, piece);
  const auto most = static_cast<int>(std::min<std::size_t>(count, 1 << 16));
  Workers own(std::min(threads_, most));
  own.run(count, piece);
}

void Jobs::run_dearest_first(const std::vector<double>& costs,
                             const std::function<void(std::size_t)>& piece) const {
  const std::vector<std::size_t> order = dearest_first(costs);
  run(order.size(), [&](std::size_t n) { piece(order[n]); });
}

std::vector<std::size_t> dearest_first(const std::vector<double>& costs) {
  std::vector<std::size_t> order(costs.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t i) { return costs[i]; });
  return order;
}

}  // namespace fiberchain::compare
