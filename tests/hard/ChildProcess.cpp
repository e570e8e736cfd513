#include "ChildProcess.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace Lixel::Tests {
namespace {

/// What a child sends before its message: what it threw, if anything.
using Complaint = std::array<char, 200>;

bool sendAll(int output, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = write(output, bytes.data(), bytes.size());
        if (sent <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

bool receiveAll(int input, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t received = read(input, bytes.data(), bytes.size());
        if (received <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(received));
    }
    return true;
}

[[noreturn]] void runChild(int output, unsigned seconds, std::size_t steps,
                           const std::function<void(std::size_t)>& work,
                           std::span<const std::byte> message) {
    // What OGRE has to say about an assertion is said by "abort".
    dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
    for (std::size_t step = 0; step < steps; ++step) {
        alarm(seconds);
        Complaint complaint{};
        try {
            work(step);
        } catch (const std::exception& exception) {
            const std::string text = std::string("throws: ") + exception.what();
            text.copy(complaint.data(), complaint.size() - 1);
        }
        const bool sent =
            sendAll(output, std::as_bytes(std::span(complaint))) && sendAll(output, message);
        if (!sent || complaint[0] != '\0') _exit(1);
    }
    _exit(0);
}

std::string endOf(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    if (!WIFSIGNALED(status)) return "exits";
    if (WTERMSIG(status) == SIGALRM) return "hangs";
    return WTERMSIG(status) == SIGABRT ? "abort" : "crashes";
}

} // namespace

std::string runApart(unsigned seconds, std::size_t steps,
                     const std::function<void(std::size_t)>& work, std::span<std::byte> message,
                     const std::function<void(std::size_t)>& done) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe to a child process");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no child process");
    if (child == 0) runChild(ends[1], seconds, steps, work, message);
    close(ends[1]);
    Complaint complaint{};
    std::vector<std::byte> received(message.size());
    std::size_t step = 0;
    while (step < steps && complaint[0] == '\0' &&
           receiveAll(ends[0], std::as_writable_bytes(std::span(complaint))) &&
           receiveAll(ends[0], received)) {
        if (complaint[0] != '\0') break;
        std::copy(received.begin(), received.end(), message.begin());
        done(step++);
    }
    close(ends[0]);
    const std::string end = endOf(child);
    if (step == steps) return {};
    return complaint[0] != '\0' ? complaint.data() : end;
}

std::string runApart(unsigned seconds, const std::function<void()>& work,
                     std::span<std::byte> message) {
    return runApart(
        seconds, 1, [&](std::size_t) { work(); }, message, [](std::size_t) {});
}

} // namespace Lixel::Tests
