#include "certify/campaign/campaign_run.hpp"

#include <fmt/format.h>

#include <atomic>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>

#include "reports/text/inputs.hpp"
#include "reports/text/progress.hpp"

namespace graze::tool {
namespace {

using Clock = std::chrono::steady_clock;

// The state that the threads share. They access it once a block.
class CampaignRun {
 public:
  CampaignRun(const CampaignJob& job, CampaignState& state)
      : job_(job),
        state_(state),
        next_(state.share().lower()),
        end_(state.share().upper()),
        progress_("campaign, casts", casts_of_share(state), state.casts_done()) {}

  void go() {
    std::vector<std::jthread> threads;
    running_ = std::max(1U, job_.threads);
    for (unsigned t = 0, count = running_; t < count; ++t) {
      threads.emplace_back([this] { work(); });
    }
    watch();
    threads.clear();
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  static std::uint64_t casts_of_share(const CampaignState& state) {
    CampaignState all;
    all.settings = state.settings;
    all.done += state.share();
    return all.casts_done();
  }

  // The next block to do, or end_.
  std::uint64_t take() {
    const bool stops = job_.stop();
    const std::lock_guard lock(mutex_);
    if (stops || failure_) next_ = end_;
    while (next_ < end_ && boost::icl::contains(state_.done, next_)) ++next_;
    return next_ < end_ ? next_++ : end_;
  }

  void work() {
    try {
      CampaignTally tally(state_.cells.size());
      for (std::uint64_t block = take(); block < end_; block = take()) {
        tally = CampaignTally(state_.cells.size());
        run_block(job_, state_.settings, block, tally);
        const std::lock_guard lock(mutex_);
        state_.tally.merge(tally);
        state_.done += BlockRange(block, block + 1);
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
    const std::lock_guard lock(mutex_);
    --running_;
    changed_.notify_one();
  }

  // Until the last thread is done: shows the progress, and saves.
  void watch() {
    constexpr auto kPace = std::chrono::milliseconds(250);
    Clock::time_point saved = Clock::now();
    std::unique_lock lock(mutex_);
    while (!changed_.wait_for(lock, kPace, [this] { return running_ == 0; })) {
      const CampaignCounts total = state_.tally.total();
      progress_.reach(state_.casts_done(), fmt::format("{} failures", total.faults + total.stalls));
      if (job_.state_file.empty() || Clock::now() - saved < job_.save_every) continue;
      const CampaignState copy = state_;
      lock.unlock();
      save(copy);
      saved = Clock::now();
      lock.lock();
    }
  }

  // A disk that is full for a while does not end a run of hours. The caller does the last write.
  void save(const CampaignState& copy) const {
    try {
      write_state(copy, job_.state_file);
    } catch (const std::exception& error) {
      progress_.wipe();
      complain(error.what());
    }
  }

  const CampaignJob& job_;
  CampaignState& state_;
  std::uint64_t next_, end_;
  Progress progress_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::exception_ptr failure_;
  unsigned running_ = 0;
};

}  // namespace

void run_block(const CampaignJob& job, const CampaignSettings& settings, std::uint64_t block,
               CampaignTally& tally) {
  const std::uint64_t first = block * settings.block;
  const std::uint64_t count = std::min(settings.block, settings.casts() - first);
  std::optional<CaseJudge> judge;
  CampaignPlan::Place last;
  for (std::uint64_t index = first; index < first + count; ++index) {
    const CampaignPlan::Place place = job.plan->place(index);
    if (!judge || place.part != last.part || place.number != last.number)
      judge.emplace(place.part->cases.draw(place.number));
    last = place;
    const DrawnCase& drawn = judge->drawn();
    const std::size_t cell = place.cell(drawn);
    if (drawn.is_question) {
      const engine::Method& contender = *place.part->cases.contenders()[place.contender];
      tally.add(index, cell, contender, drawn, judge->ask(contender));
    } else {
      tally.add_skipped(cell);
    }
  }
}

void run_campaign(const CampaignJob& job, CampaignState& state) { CampaignRun(job, state).go(); }

}  // namespace graze::tool
