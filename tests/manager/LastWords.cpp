#include "LastWords.h"

#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstddef>
#include <cstring>

namespace Lixel::Tests::LastWords {
namespace {

constexpr std::size_t DeedsTold = 40;

// For the signal handler, which may neither allocate nor format.
const std::string* theWalk = nullptr;
const std::vector<std::string>* theDeeds = nullptr;
const char* theDeed = "";

void write(const char* text) {
    if (::write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

void tell(int signal) {
    write(theWalk->c_str());
    write("\n");
    const std::size_t count = theDeeds->size();
    for (std::size_t i = count - std::min(count, DeedsTold); i < count; ++i) {
        write("  ");
        write((*theDeeds)[i].c_str());
        write("\n");
    }
    write(theDeed);
    write("\n");
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

} // namespace

void begin(const std::string& walk, const std::vector<std::string>& deeds) {
    theWalk = &walk;
    theDeeds = &deeds;
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE})
        std::signal(signal, tell);
}

void say(const char* deed) {
    theDeed = deed;
}

void forget() {
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE})
        std::signal(signal, SIG_DFL);
}

} // namespace Lixel::Tests::LastWords
