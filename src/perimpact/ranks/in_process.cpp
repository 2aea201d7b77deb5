#include "perimpact/ranks/in_process.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "base/error.hpp"
#include "base/parallel.hpp"

namespace perimpact {

namespace {

/// What the ranks of a run share: one entry of each rank for the present call, and the barrier between calls.
class Meeting {
 public:
  explicit Meeting(int size) : entries_(static_cast<std::size_t>(size)), waiting_for_(size), size_(size) {}

  int size() const { return size_; }

  /// Publishes an entry, and calls read(entries) when all ranks have published theirs. The entry is not accessed after the call.
  template <class Read>
  void meet(int rank, const void* entry, const Read& read) {
    entries_[static_cast<std::size_t>(rank)] = entry;
    wait();
    read(entries_);
    wait();
  }

  void abort() noexcept {
    const std::lock_guard guard(mutex_);
    is_aborted_ = true;
    all_here_.notify_all();
  }

 private:
  void wait() {
    std::unique_lock lock(mutex_);
    if (!is_aborted_ && --waiting_for_ == 0) {
      waiting_for_ = size_, ++meeting_;
      all_here_.notify_all();
    } else {
      all_here_.wait(lock, [this, of = meeting_] { return is_aborted_ || meeting_ != of; });
    }
    if (is_aborted_) throw fccda::RunError("another rank of the run has failed");
  }

  std::vector<const void*> entries_;
  std::mutex mutex_;
  std::condition_variable all_here_;
  int waiting_for_, size_;
  long meeting_ = 0;
  bool is_aborted_ = false;
};

class InProcess final : public Ranks {
 public:
  InProcess(Meeting& meeting, int rank) : meeting_(meeting), rank_(rank) {}
  int rank() const override { return rank_; }
  int size() const override { return meeting_.size(); }

  void exchange(std::span<const Outgoing> send, std::span<const Incoming> receive) override {
    meeting_.meet(rank_, &send, [&](const std::vector<const void*>& entries) {
      for (const Incoming& message : receive) {
        const auto& sent = *static_cast<const std::span<const Outgoing>*>(entries[static_cast<std::size_t>(message.from)]);
        const auto found = std::ranges::find(sent, rank_, &Outgoing::to);
        if (found == sent.end() || found->bytes.size() != message.bytes.size()) throw fccda::RunError("ranks disagree about the messages between them");
        std::ranges::copy(found->bytes, message.bytes.begin());
      }
    });
  }
  using Ranks::max;
  using Ranks::sum;
  void sum(std::span<std::int64_t> values) override {
    combine(values, [](std::int64_t a, std::int64_t b) { return static_cast<std::int64_t>(static_cast<std::uint64_t>(a) + static_cast<std::uint64_t>(b)); });
  }
  void max(std::span<double> values) override {
    combine(values, [](double a, double b) { return std::max(a, b); });
  }
  std::vector<Bytes> gather_all(std::span<const std::byte> bytes) override {
    std::vector<Bytes> all;
    meeting_.meet(rank_, &bytes, [&](const std::vector<const void*>& entries) {
      for (const void* entry : entries) {
        const auto& of_rank = *static_cast<const std::span<const std::byte>*>(entry);
        all.emplace_back(of_rank.begin(), of_rank.end());
      }
    });
    return all;
  }
  std::vector<Bytes> gather(std::span<const std::byte> bytes) override {
    std::vector<Bytes> all = gather_all(bytes);
    return is_root() ? all : std::vector<Bytes>();
  }
  void broadcast(Bytes& bytes) override { bytes = std::move(gather_all(bytes).front()); }
  void abort() noexcept override { meeting_.abort(); }

 private:
  template <class T, class Combine>
  void combine(std::span<T> values, const Combine& of_two) {
    const std::vector<T> own(values.begin(), values.end());
    const std::span<const T> published(own);
    meeting_.meet(rank_, &published, [&](const std::vector<const void*>& entries) {
      std::ranges::copy(*static_cast<const std::span<const T>*>(entries.front()), values.begin());
      for (std::size_t rank = 1; rank < entries.size(); ++rank) {
        const auto& others = *static_cast<const std::span<const T>*>(entries[rank]);
        for (std::size_t k = 0; k < values.size(); ++k) values[k] = of_two(values[k], others[k]);
      }
    });
  }

  Meeting& meeting_;
  int rank_;
};

}  // namespace

void run_in_process(int size, const std::function<void(Ranks&)>& run) {
  Meeting meeting(size);
  std::mutex mutex;
  std::exception_ptr first;
  const int threads = fccda::thread_count();
  std::vector<std::thread> ranks;
  for (int rank = 0; rank < size; ++rank)
    ranks.emplace_back([&, rank] {
      fccda::use_threads(threads);  // a setting of each thread that begins parallel loops
      InProcess its(meeting, rank);
      try {
        run(its);
      } catch (...) {
        {
          const std::lock_guard guard(mutex);
          if (!first) first = std::current_exception();
        }
        meeting.abort();
      }
    });
  for (std::thread& rank : ranks) rank.join();
  if (first) std::rethrow_exception(first);
}

}  // namespace perimpact
