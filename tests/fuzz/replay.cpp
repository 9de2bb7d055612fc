// SPDX-License-Identifier: Apache-2.0
// The main function of a target without libFuzzer: runs its seeds, the inputs that once failed, and seeded
// mutations of all of them for some seconds. The same seed gives the same inputs in the same order.
#include "tests/fuzz/fuzz_target.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>

#include <fcntl.h>
#include <unistd.h>

namespace {

using campanel::fuzz::Bytes;
using Clock = std::chrono::steady_clock;

constexpr std::size_t longestInput = 16'384;
constexpr int usageError = 2;

struct Options {
    std::string found;   // folder of the inputs that once failed
    std::string seedsTo; // folder to write the seeds into, nothing else is done
    std::string only;    // a single input
    std::string failure; // file for the input that ends the program
    double seconds = 10;
    std::uint64_t cases = UINT64_MAX;
    std::uint64_t seed = 1;
};

// The input that is being run, for the handler of signals.
const Bytes* running = nullptr;
const char* failureFile = nullptr;

// Writes the input that ended the program; only calls that a signal handler may make.
void writeRunning(int signal)
{
    const int file = failureFile == nullptr ? -1 : open(failureFile, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    if (running != nullptr && file >= 0 && write(file, running->data(), running->size()) >= 0) {
        static constexpr char said[] = "the input is in the file of --failure\n";
        (void)!write(STDERR_FILENO, said, sizeof said - 1);
    }
    std::signal(signal, SIG_DFL);
    (void)raise(signal);
}

Bytes contentOf(const std::filesystem::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return Bytes(std::istreambuf_iterator<char>(file), {});
}

// Returns the files of the folder in the order of their names; none when there is no such folder.
std::vector<Bytes> filesIn(const std::string& folder)
{
    std::vector<std::filesystem::path> paths;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
        if (entry.is_regular_file())
            paths.push_back(entry.path());
    }
    std::ranges::sort(paths);
    std::vector<Bytes> files;
    for (const auto& path : paths)
        files.push_back(contentOf(path));
    return files;
}

class Mutator {
public:
    Mutator(const std::vector<Bytes>& corpus, std::uint64_t seed)
        : m_corpus(corpus)
        , m_random(seed)
    {
    }

    // Returns one of the corpus, changed one to eight times.
    Bytes next()
    {
        Bytes input = m_corpus[below(m_corpus.size())];
        for (std::size_t changes = 1 + below(8); changes != 0; --changes)
            change(input);
        input.resize(std::min(input.size(), longestInput));
        return input;
    }

private:
    using Distance = std::ptrdiff_t;

    std::size_t below(std::size_t count) { return count == 0 ? 0 : m_random() % count; }
    Distance place(const Bytes& input) { return static_cast<Distance>(below(input.size() + 1)); }
    std::uint8_t any() { return static_cast<std::uint8_t>(m_random()); }

    void change(Bytes& input)
    {
        static constexpr std::uint8_t edges[]{0, 1, 0x7F, 0x80, 0xFE, 0xFF, '\n', '"', '{', ',', '-', '9'};
        const std::size_t kind = input.empty() ? 3 : below(8);
        const std::size_t at = below(input.size());
        switch (kind) {
        case 0:
            input[at] = static_cast<std::uint8_t>(input[at] ^ (1u << below(8)));
            break;
        case 1:
            input[at] = any();
            break;
        case 2:
            input[at] = edges[below(std::size(edges))];
            break;
        case 3:
            input.insert(input.begin() + place(input), 1 + below(4), any());
            break;
        case 4:
            input.erase(input.begin() + static_cast<Distance>(at),
                        input.begin() + static_cast<Distance>(
                                            at + 1 + below(std::min<std::size_t>(input.size() - at, 16))));
            break;
        case 5: // repeats a part of itself
            insertPart(input, input);
            break;
        case 6: // takes over a part of another one
            insertPart(input, m_corpus[below(m_corpus.size())]);
            break;
        default: // adds a little to a byte, so that counts and lengths are one off
            input[at] = static_cast<std::uint8_t>(input[at] + below(9) - 4);
            break;
        }
    }

    void insertPart(Bytes& input, const Bytes& source)
    {
        if (source.empty() || input.size() > longestInput)
            return;
        const std::size_t first = below(source.size());
        const std::size_t count = 1 + below(std::min<std::size_t>(source.size() - first, 64));
        const Bytes part(source.begin() + static_cast<Distance>(first),
                         source.begin() + static_cast<Distance>(first + count));
        input.insert(input.begin() + place(input), part.begin(), part.end());
    }

    const std::vector<Bytes>& m_corpus;
    std::mt19937_64 m_random;
};

template <typename Number> bool takeNumber(std::string_view text, Number& number)
{
    return std::from_chars(text.data(), text.data() + text.size(), number).ec == std::errc();
}

bool takeOption(Options& options, std::string_view name, const char* value)
{
    if (name == "--found")
        options.found = value;
    else if (name == "--seeds")
        options.seedsTo = value;
    else if (name == "--input")
        options.only = value;
    else if (name == "--failure")
        options.failure = value;
    else if (name == "--seconds")
        return takeNumber(value, options.seconds);
    else if (name == "--cases")
        return takeNumber(value, options.cases);
    else
        return name == "--seed" && takeNumber(value, options.seed);
    return true;
}

void run(const Bytes& input)
{
    running = &input;
    campanel::fuzz::runTarget(input);
    running = nullptr;
}

void writeSeeds(const std::string& folder)
{
    std::filesystem::create_directories(folder);
    int number = 0;
    for (const Bytes& seed : campanel::fuzz::targetSeeds()) {
        std::ofstream file(folder + "/seed_" + std::to_string(number++), std::ios::binary);
        file.write(reinterpret_cast<const char*>(seed.data()), static_cast<std::streamsize>(seed.size()));
    }
}

int replay(const Options& options)
{
    std::vector<Bytes> corpus = campanel::fuzz::targetSeeds();
    const std::size_t seeds = corpus.size();
    for (Bytes& found : filesIn(options.found))
        corpus.push_back(std::move(found));
    std::printf("seed %llu, %zu seeds, %zu found inputs\n", static_cast<unsigned long long>(options.seed),
                seeds, corpus.size() - seeds);
    std::fflush(stdout);
    for (const Bytes& input : corpus)
        run(input);
    Mutator mutator(corpus, options.seed);
    const auto begin = Clock::now();
    const auto elapsed = [begin] { return std::chrono::duration<double>(Clock::now() - begin).count(); };
    std::uint64_t cases = 0;
    while (cases < options.cases && elapsed() < options.seconds) {
        const Bytes input = mutator.next();
        run(input);
        ++cases;
    }
    std::printf("%llu mutations in %.1f s\n", static_cast<unsigned long long>(cases), elapsed());
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    Options options;
    for (int i = 1; i < argc; i += 2) {
        if (i + 1 < argc && takeOption(options, argv[i], argv[i + 1]))
            continue;
        std::fprintf(stderr,
                     "usage: %s [--found FOLDER] [--seconds N] [--cases N] [--seed N] [--failure FILE]\n"
                     "       %s --input FILE | --seeds FOLDER\n",
                     argv[0], argv[0]);
        return usageError;
    }
    if (!options.seedsTo.empty()) {
        writeSeeds(options.seedsTo);
        return 0;
    }
    failureFile = options.failure.empty() ? nullptr : options.failure.c_str();
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGILL, SIGBUS, SIGTERM})
        std::signal(signal, writeRunning);
    if (!options.only.empty()) {
        run(contentOf(options.only));
        return 0;
    }
    return replay(options);
}
