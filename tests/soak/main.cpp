// SPDX-License-Identifier: Apache-2.0
// campanel-soak: the real controller program behind a line with every class of fault, operated by the panel's
// client and, beside it, by a plain libmodbus master. Exits with 1 when the panel's client accepted a wrong
// value, repeated a command, mixed tables or did not recover.
#include "tests/soak/panel_master.h"
#include "tests/soak/plain_master.h"
#include "tests/soak/report.h"

#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <getopt.h>
#include <mutex>
#include <unistd.h>

using namespace campanel::soak;

namespace {

constexpr const char* help =
    R"(usage: campanel-soak [OPTION]...

  --exchanges N        of the panel's client, over all classes of fault (200000)
  --plain-exchanges N  of each plain libmodbus master (a quarter of that; 0: none)
  --seed N             of everything (1)
  --baud N             of client and line (115200)
  --paced              bytes take as long as on the wire
  --allowance MS       time for an answer beyond that on the wire (20)
  --threads N          controllers at the same time (12)
  --clock-may-stand    the controller's computer may stop it for a while: a firmware in QEMU
  --class TEXT         only the classes whose name contains it
)";

struct Options {
    std::uint64_t exchanges = 200'000;
    std::optional<std::uint64_t> plainExchanges;
    std::uint64_t seed = 1;
    std::uint32_t baud = 115200;
    bool paced = false;
    std::uint32_t allowanceMs = 20;
    std::uint32_t threads = 12;
    ControllerTime time = ControllerTime::Steady;
    std::string className;
};

template <typename Number> bool takeNumber(const char* text, Number& number)
{
    const char* end = text + std::strlen(text);
    const auto parsed = std::from_chars(text, end, number);
    return parsed.ec == std::errc() && parsed.ptr == end;
}

// Returns nothing after --help or an error.
std::optional<Options> parseOptions(int argc, char** argv)
{
    Options options;
    const option table[] = {{"exchanges", 1, nullptr, 'e'}, {"plain-exchanges", 1, nullptr, 'l'},
                            {"seed", 1, nullptr, 's'},      {"baud", 1, nullptr, 'b'},
                            {"paced", 0, nullptr, 'p'},     {"allowance", 1, nullptr, 'a'},
                            {"threads", 1, nullptr, 't'},   {"class", 1, nullptr, 'c'},
                            {"help", 0, nullptr, 'h'},      {"clock-may-stand", 0, nullptr, 'm'},
                            {nullptr, 0, nullptr, 0}};
    bool good = true;
    for (int code = 0; good && (code = getopt_long(argc, argv, "", table, nullptr)) != -1;) {
        if (code == 'e')
            good = takeNumber(optarg, options.exchanges);
        else if (code == 'l')
            good = takeNumber(optarg, options.plainExchanges.emplace());
        else if (code == 's')
            good = takeNumber(optarg, options.seed);
        else if (code == 'b')
            good = takeNumber(optarg, options.baud);
        else if (code == 'a')
            good = takeNumber(optarg, options.allowanceMs);
        else if (code == 't')
            good = takeNumber(optarg, options.threads) && options.threads > 0;
        else if (code == 'c')
            options.className = optarg;
        else if (code == 'p')
            options.paced = true;
        else if (code == 'm')
            options.time = ControllerTime::MayStand;
        else
            good = false;
    }
    if (good && optind == argc)
        return options;
    std::fputs(help, stdout);
    return std::nullopt;
}

// One separate controller for each class and master.
struct Work {
    std::size_t faultClass = 0;
    std::optional<modbus_error_recovery_mode> plain; // empty: the panel's client
    std::uint64_t exchanges = 0;
    std::uint64_t seed = 0;
};

std::vector<Work> allWork(const Options& options)
{
    std::vector<std::size_t> chosen;
    for (std::size_t i = 0; i < faultClasses.size(); ++i) {
        if (faultClasses[i].name.find(options.className) != std::string_view::npos)
            chosen.push_back(i);
    }
    const std::uint64_t count = std::max<std::uint64_t>(1, chosen.size());
    const std::uint64_t each = (options.exchanges + count - 1) / count;
    const std::uint64_t eachPlain =
        (options.plainExchanges.value_or(options.exchanges / 4) + count - 1) / count;
    std::vector<Work> work;
    for (const std::size_t i : chosen) {
        const std::uint64_t seed = options.seed * 1000 + i;
        work.push_back({i, std::nullopt, each, seed});
        for (const auto mode : {MODBUS_ERROR_RECOVERY_NONE, MODBUS_ERROR_RECOVERY_PROTOCOL}) {
            if (eachPlain > 0)
                work.push_back({i, mode, eachPlain, seed});
        }
    }
    return work;
}

void doWork(const Work& work, const Options& options, const std::filesystem::path& folder, Tally& tally,
            Watch& watch)
{
    MasterSettings settings;
    settings.line.baud = options.baud;
    settings.answerAllowance = std::chrono::milliseconds{options.allowanceMs};
    settings.seed = work.seed;
    settings.time = options.time;
    const FaultClass& faults = faultClasses.at(work.faultClass);
    try {
        std::filesystem::create_directories(folder);
        FaultyController controller(folder, options.paced, options.baud);
        Tally preparation;
        PanelMaster panel(controller, faults, settings, work.plain ? preparation : tally, watch);
        panel.prepare();
        if (!work.plain) {
            panel.run(work.exchanges);
            return;
        }
        panel.disconnect();
        PlainMaster(controller, faults, settings, *work.plain, panel.truth(), tally, watch)
            .run(work.exchanges);
    } catch (const std::exception& error) {
        tally.find(tally.hangs, error.what());
    }
}

// Ends the program when a call does not return: nothing else could report it.
void watchOver(const std::vector<Watch>& watches, const std::atomic<bool>& finished)
{
    constexpr double longestCallS = 30;
    constexpr std::chrono::milliseconds period{100};
    while (!finished) {
        std::this_thread::sleep_for(period);
        for (const Watch& watch : watches) {
            if (watch.seconds() > longestCallS) {
                std::printf("soak: HANG, '%s' has not returned for %.0f s\n", watch.what(), watch.seconds());
                std::fflush(stdout);
                _exit(1);
            }
        }
    }
}

void runAll(const std::vector<Work>& work, const Options& options, const std::filesystem::path& folder,
            Results& results)
{
    std::atomic<std::size_t> next{0};
    std::atomic<bool> finished{false};
    std::mutex mutex; // guards results
    std::vector<Watch> watches(options.threads);
    std::vector<std::thread> threads;
    for (Watch& watch : watches) {
        threads.emplace_back([&] {
            for (std::size_t i = next++; i < work.size(); i = next++) {
                Tally tally;
                doWork(work[i], options, folder / std::to_string(i), tally, watch);
                const std::lock_guard lock(mutex);
                ClassResult& result = results.at(work[i].faultClass);
                if (!work[i].plain)
                    result.panel.add(tally);
                else
                    result.plain.at(*work[i].plain == MODBUS_ERROR_RECOVERY_NONE ? 0 : 1).add(tally);
            }
        });
    }
    std::thread watchman(watchOver, std::cref(watches), std::cref(finished));
    for (std::thread& thread : threads)
        thread.join();
    finished = true;
    watchman.join();
}

} // namespace

int main(int argc, char** argv)
{
    const auto options = parseOptions(argc, argv);
    if (!options)
        return 2;
    std::string folder = (std::filesystem::temp_directory_path() / "campanel-soak-XXXXXX").string();
    if (mkdtemp(folder.data()) == nullptr) {
        std::perror("campanel-soak: no folder for the controllers");
        return 2;
    }
    std::signal(SIGPIPE, SIG_IGN); // an ended controller is reported as text
    const auto begun = Clock::now();
    Results results;
    runAll(allWork(*options), *options, folder, results);
    std::error_code error;
    std::filesystem::remove_all(folder, error);
    std::printf("seed %llu, %u baud%s, allowance %u ms, %.0f s\n\n",
                static_cast<unsigned long long>(options->seed), options->baud,
                options->paced ? ", paced" : "", options->allowanceMs,
                std::chrono::duration<double>(Clock::now() - begun).count());
    return report(results) ? 0 : 1;
}
