#include "Sequence.h"

#include "Deeds.h"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <fmt/core.h>
#include <new>

namespace Lixel::Tests {
namespace {

/// A line of text that outlives the process.
using Line = std::array<char, 240>;

/// What the child writes and the parent reads, whatever becomes of the child.
struct Report {
    std::size_t step = 0;
    std::size_t begun = 0; ///< deeds, the one that did not return among them
    std::size_t deeds = 0;
    std::size_t frames = 0;
    CheckCounts counts;
    bool finished = false;
    Line what{};
    std::array<Line, 20> last{};
};

void write(Line& line, const std::string& text) {
    line.fill('\0');
    text.copy(line.data(), line.size() - 1);
}

void play(Application& application, const Sequence& sequence, Report& report) {
    for (const std::size_t step : sequence.steps) {
        report.step = step;
        Line& line = report.last.at(report.deeds % report.last.size());
        // What a deed that does not return is known by.
        write(line, fmt::format("{}: ...", step));
        ++report.begun;
        Random random(sequence.seed * 0x2545F4914F6CDD1DULL + step);
        write(line, fmt::format("{}: {}", step, doSomething(application, random)));
        if (sequence.verbose) fmt::print("{}\n", line.data());
        ++report.deeds;
        if (!random.oneIn(2)) continue;
        application.drawFrame();
        ++report.frames;
        if (report.frames % sequence.checkEvery != 0) continue;
        const std::string wrong = findWrongShadow(application, report.counts, sequence.pictureFile);
        if (!wrong.empty()) return write(report.what, wrong);
    }
    report.finished = true;
}

[[noreturn]] void runChild(const Sequence& sequence, Report& report) {
    {
        Application application;
        // An exception's type may live in a plugin, which goes with the application.
        try {
            play(application, sequence, report);
        } catch (const std::exception& exception) {
            report.finished = false;
            write(report.what, std::string("throws: ") + exception.what());
        }
    }
    // Not _exit: leaks are looked for at the end.
    std::exit(report.finished ? 0 : 1);
}

std::string endOf(pid_t child, const Report& report) {
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) return std::string("ends by ") + strsignal(WTERMSIG(status));
    if (report.what[0] != '\0') return report.what.data();
    if (!report.finished) return "ends early; see above";
    return WEXITSTATUS(status) == 0 ? "" : "has an end of its own; see above";
}

} // namespace

SequenceEnd runSequence(const Sequence& sequence) {
    void* const shared =
        mmap(nullptr, sizeof(Report), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (shared == MAP_FAILED) throw std::runtime_error("no memory to share with a process");
    Report& report = *new (shared) Report;
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process of its own");
    if (child == 0) runChild(sequence, report);

    SequenceEnd end;
    end.what = endOf(child, report);
    end.failed = !end.what.empty();
    end.step = report.step;
    end.deeds = report.deeds;
    end.frames = report.frames;
    end.counts = report.counts;
    const std::size_t kept = std::min(report.begun, report.last.size());
    for (std::size_t i = report.begun - kept; i < report.begun; ++i)
        end.lastDeeds.emplace_back(report.last.at(i % report.last.size()).data());
    munmap(shared, sizeof(Report));
    return end;
}

} // namespace Lixel::Tests
