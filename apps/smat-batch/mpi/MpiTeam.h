#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "smatcore/jobs/CaseTeam.h"

namespace smat::batch {

/// A team of the ranks of MPI_COMM_WORLD; rank 0 leads and draws, too. Made between
/// MPI_Init_thread, of at least MPI_THREAD_SERIALIZED, and MPI_Finalize.
///
/// The leader listens in a thread of its own, the only one of its process that speaks MPI
/// meanwhile: a rank says which sweep it draws of (a head), asks for cases and gets numbers, sends
/// what they came to. Nobody waits in MPI itself, which would keep a core busy.
class MpiTeam : public CaseTeam {
  public:
    MpiTeam();
    ~MpiTeam() override;
    MpiTeam(const MpiTeam&) = delete;
    MpiTeam& operator=(const MpiTeam&) = delete;

    bool isLeader() const override { return rank_ == 0; }
    std::size_t size() const override { return static_cast<std::size_t>(ranks_); }
    int rank() const { return rank_; }

    std::unique_ptr<CaseStore> lead(CaseFile& file) override;
    std::unique_ptr<CaseStore> follow(std::map<std::string, std::string> inputs) override;
    void finish(const std::function<void(std::size_t done)>& progress) override;
    void meet() override;

  private:
    class Leading;
    class Following;
    struct Shared;

    void listen(std::stop_token stop);
    void answer(int tag, int from, const std::string& text);

    int rank_ = 0, ranks_ = 1;
    std::shared_ptr<Shared> shared_; ///< by the leader's store and its listening thread
    std::jthread listening_;
};

} // namespace smat::batch
