#include "demos/processes/own_process.h"

#include <exception>

#include "demos/processes/process_pool.h"
#include "demos/text/stop.h"
#include "render/error.h"

namespace demos {
namespace {

/// How the work ended: the first character of its text. After `stopped` comes the exit code, as a character.
constexpr char kReturned = '+', kStopped = 's', kFailed = '-';

std::string endOf(const std::function<std::string()>& work) {
    try {
        return kReturned + work();
    } catch (const Stop& stop) {
        return std::string{kStopped, static_cast<char>(stop.code())} + stop.what();
    } catch (const std::exception& error) {
        return std::string(1, kFailed) + error.what();
    }
}

}  // namespace

std::string inOwnProcess(const std::string& what, const std::function<std::string()>& work) {
    std::string end;
    runInProcesses(1, 1, [&](int) { return endOf(work); },
                   [&](int, const PoolResult& result) {
                       end = result.ended ? result.text : std::string(1, kFailed) + what + ' ' + result.text;
                   });
    if (end.front() == kReturned) return end.substr(1);
    if (end.front() == kFailed) throw render::Error(end.substr(1));
    throw Stop(static_cast<Exit>(static_cast<unsigned char>(end[1])), end.substr(2));
}

}  // namespace demos
