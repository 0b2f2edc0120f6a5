#include "apps/smat-batch/mpi/MpiTeam.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <mpi.h>

#include "irsg/core/CsvTable.h"
#include "irsg/core/Errors.h"

namespace smat::batch {

namespace {

enum Tag { head = 1, request, cases, record, bye };

constexpr std::chrono::milliseconds pause{1};

void send(int to, Tag tag, const std::string& text) {
    MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
}

struct Message {
    int tag = 0, from = 0;
    std::string text;
};

/// What has come from `from`; none where nothing has.
std::optional<Message> received(int from, int tag) {
    int isThere = 0;
    MPI_Status status{};
    MPI_Iprobe(from, tag, MPI_COMM_WORLD, &isThere, &status);
    if (isThere == 0)
        return std::nullopt;
    int size_B = 0;
    MPI_Get_count(&status, MPI_CHAR, &size_B);
    Message message{status.MPI_TAG, status.MPI_SOURCE,
                    std::string(static_cast<std::size_t>(size_B), ' ')};
    MPI_Recv(message.text.data(), size_B, MPI_CHAR, message.from, message.tag, MPI_COMM_WORLD,
             MPI_STATUS_IGNORE);
    return message;
}

std::vector<std::size_t> numbersIn(const std::string& text) {
    std::vector<std::size_t> numbers;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const auto number = irsg::parseNumber(text.substr(begin, end - begin));
        numbers.push_back(static_cast<std::size_t>(number.value()));
        begin = end + 1;
    }
    return numbers;
}

/// Of a run that goes through the cases in ascending order: whether one is its, where more are to
/// be had by `more`, ascending too, and none for ever once that gives none.
class OwnCases {
  public:
    template <typename More>
    bool has(std::size_t i, More more) {
        while (!isOver_ && (mine_.empty() || mine_.back() < i)) {
            mine_ = more();
            isOver_ = mine_.empty();
        }
        return std::ranges::binary_search(mine_, i);
    }

  private:
    std::vector<std::size_t> mine_;
    bool isOver_ = false;
};

} // namespace

struct MpiTeam::Shared {
    explicit Shared(CaseFile& of) : file(of) {}

    CaseFile& file;
    std::mutex mutex; ///< of all that follows, and of the file
    std::optional<CaseDispenser> dispenser;
    std::size_t expected = 0, recorded = 0; ///< of the cases that were not known
    std::size_t known = 0;
    int atWork = 0; ///< ranks that have not said yet that they are done
    std::exception_ptr thrown;

    std::vector<std::size_t> next() {
        const std::scoped_lock lock(mutex);
        if (thrown)
            std::rethrow_exception(thrown);
        return dispenser->next();
    }
    void add(std::size_t i, const CaseRecord& one) {
        const std::scoped_lock lock(mutex);
        file.add(i, one);
        ++recorded;
    }
    bool isOver() {
        const std::scoped_lock lock(mutex);
        return atWork == 0 && recorded == expected;
    }
};

class MpiTeam::Leading : public CaseStore {
  public:
    Leading(MpiTeam& team, std::shared_ptr<Shared> shared)
        : team_(team), shared_(std::move(shared)) {}

    void begin(const AnalysisData& data, std::size_t cases) override {
        shared_->file.begin(data, cases);
        std::vector<std::size_t> open;
        for (std::size_t i = 0; i < cases; ++i)
            if (shared_->file.known(i) == nullptr)
                open.push_back(i);
        shared_->expected = open.size();
        shared_->known = cases - open.size();
        shared_->atWork = team_.ranks_ - 1;
        shared_->dispenser.emplace(std::move(open), team_.size());
        team_.listening_ =
            std::jthread([&team = team_](const std::stop_token& stop) { team.listen(stop); });
    }
    const CaseRecord* known(std::size_t i) const override { return shared_->file.known(i); }
    bool isMine(std::size_t i) const override {
        return own_.has(i, [this] { return shared_->next(); });
    }
    void add(std::size_t i, const CaseRecord& record) override { shared_->add(i, record); }
    std::size_t expected(std::size_t cases) const override { return cases; }

  private:
    MpiTeam& team_;
    std::shared_ptr<Shared> shared_;
    mutable OwnCases own_;
};

class MpiTeam::Following : public CaseStore {
  public:
    explicit Following(std::map<std::string, std::string> inputs) : inputs_(std::move(inputs)) {}
    ~Following() override { send(0, Tag::bye, ""); }
    Following(const Following&) = delete;
    Following& operator=(const Following&) = delete;

    void begin(const AnalysisData& data, std::size_t cases) override {
        CaseFile::Options options;
        options.inputs = inputs_;
        send(0, Tag::head, CaseFile::headText(data, cases, options));
    }
    const CaseRecord* known(std::size_t) const override { return nullptr; }
    bool isMine(std::size_t i) const override {
        return own_.has(i, [] {
            send(0, Tag::request, "");
            for (;;) {
                if (const auto message = received(0, Tag::cases))
                    return numbersIn(message->text);
                std::this_thread::sleep_for(pause);
            }
        });
    }
    void add(std::size_t i, const CaseRecord& record) override {
        send(0, Tag::record, CaseFile::recordText(i, record));
    }
    std::size_t expected(std::size_t cases) const override { return cases; }

  private:
    std::map<std::string, std::string> inputs_;
    mutable OwnCases own_;
};

MpiTeam::MpiTeam() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
}

MpiTeam::~MpiTeam() = default;

std::unique_ptr<CaseStore> MpiTeam::lead(CaseFile& file) {
    shared_ = std::make_shared<Shared>(file);
    return std::make_unique<Leading>(*this, shared_);
}

std::unique_ptr<CaseStore> MpiTeam::follow(std::map<std::string, std::string> inputs) {
    return std::make_unique<Following>(std::move(inputs));
}

void MpiTeam::listen(std::stop_token stop) {
    while (!stop.stop_requested() && !shared_->isOver())
        if (const auto message = received(MPI_ANY_SOURCE, MPI_ANY_TAG))
            answer(message->tag, message->from, message->text);
        else
            std::this_thread::sleep_for(pause);
}

void MpiTeam::answer(int tag, int from, const std::string& text) {
    const std::string who = fmt::format("rank {}", from);
    std::vector<std::size_t> numbers;
    try {
        if (tag == Tag::head)
            shared_->file.checkSameSweep(text, who);
        else if (tag == Tag::record)
            std::apply([this](std::size_t i, const CaseRecord& one) { shared_->add(i, one); },
                       CaseFile::recordFrom(text, who));
        else if (tag == Tag::request)
            numbers = shared_->next();
    } catch (...) {
        const std::scoped_lock lock(shared_->mutex);
        shared_->thrown = shared_->thrown ? shared_->thrown : std::current_exception();
    }
    if (tag == Tag::bye) {
        const std::scoped_lock lock(shared_->mutex);
        --shared_->atWork;
    }
    if (tag == Tag::request)
        send(from, Tag::cases, fmt::format("{}", fmt::join(numbers, " ")));
}

void MpiTeam::finish(const std::function<void(std::size_t done)>& progress) {
    for (;;) {
        {
            const std::scoped_lock lock(shared_->mutex);
            if (shared_->thrown)
                std::rethrow_exception(shared_->thrown);
            progress(shared_->known + shared_->recorded);
            if (shared_->recorded == shared_->expected)
                break;
        }
        constexpr std::chrono::milliseconds glance{20};
        std::this_thread::sleep_for(glance);
    }
    listening_.join();
}

void MpiTeam::meet() {
    MPI_Request request{};
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    for (int isThere = 0; isThere == 0;) {
        MPI_Test(&request, &isThere, MPI_STATUS_IGNORE);
        if (isThere == 0)
            std::this_thread::sleep_for(pause);
    }
}

} // namespace smat::batch
