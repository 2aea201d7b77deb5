#include "perimpact/ranks/in_process.hpp"

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

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

  /// Copies a message for another rank. Messages between two ranks are numbered at both ends, in the order in which they are sent and expected.
  void send(int from, int to, std::span<const std::byte> bytes) {
    const std::lock_guard guard(mutex_);
    Mail& mail = mail_[{from, to}];
    mail.messages[mail.sent++].assign(bytes.begin(), bytes.end());
    all_here_.notify_all();
  }
  long expect(int from, int to) {
    const std::lock_guard guard(mutex_);
    return mail_[{from, to}].expected++;
  }
  Ranks::Bytes receive(int from, int to, long number) {
    std::unique_lock lock(mutex_);
    std::map<long, Ranks::Bytes>& messages = mail_[{from, to}].messages;
    all_here_.wait(lock, [&] { return is_aborted_ || messages.contains(number); });
    if (!messages.contains(number)) throw_of_others();
    return std::move(messages.extract(number).mapped());
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
    if (is_aborted_) throw_of_others();
  }
  [[noreturn]] static void throw_of_others() { throw fccda::RunError("another rank of the run has failed"); }

  std::vector<const void*> entries_;
  struct Mail {
    std::map<long, Ranks::Bytes> messages;  // by number
    long sent = 0, expected = 0;
  };
  std::map<std::pair<int, int>, Mail> mail_;  // from and to
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

  std::unique_ptr<Exchange> begin_exchange(std::span<const Outgoing> send, std::span<const Incoming> receive) override {
    for (const Outgoing& message : send) meeting_.send(rank_, message.to, message.bytes);
    auto messages = std::make_unique<Messages>(meeting_, rank_);
    for (const Incoming& message : receive) messages->expected.emplace_back(message, meeting_.expect(message.from, rank_));
    return messages;
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
  struct Messages final : Exchange {
    Messages(Meeting& of, int to) : meeting(of), rank(to) {}
    void complete() override {
      for (const auto& [message, number] : expected) {
        const Bytes bytes = meeting.receive(message.from, rank, number);
        if (bytes.size() != message.bytes.size()) throw fccda::RunError("ranks disagree about the messages between them");
        std::ranges::copy(bytes, message.bytes.begin());
      }
    }
    Meeting& meeting;
    int rank;
    std::vector<std::pair<Incoming, long>> expected;
  };

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
