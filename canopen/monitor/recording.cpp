// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/monitor/recording.hpp"

#include "canopen/monitor/readers.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <utility>

namespace counterpoint::monitor
{
namespace
{
constexpr std::size_t kMostBytes = 2U * 1024U * 1024U * 1024U;

/// Closes what was opened.
class Descriptor
{
  public:
    explicit Descriptor(const int number) noexcept : number_(number)
    {
    }
    ~Descriptor()
    {
        if (number_ >= 0)
        {
            static_cast<void>(::close(number_));
        }
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    [[nodiscard]] int Number() const noexcept
    {
        return number_;
    }

  private:
    int number_;
};

[[noreturn]] void Refuse(const std::string& path, const std::string& wrong, const std::string& expected)
{
    throw cia306::InputError(path, 0U, {wrong, expected});
}
void RefuseCompressed(const std::string& file, const std::string_view magic)
{
    constexpr std::array<std::pair<std::string_view, const char*>, 3U> kinds{
        {{"\x1F\x8B", "gzip"}, {"\xFD\x37zX", "xz"}, {"\x28\xB5\x2F\xFD", "zstd"}}};
    for (const auto& [begin, name] : kinds)
    {
        if (magic.substr(0U, begin.size()) == begin)
        {
            Refuse(file, std::string("it is compressed (") + name + ")", "the recording itself, unpacked");
        }
    }
}
} // namespace

std::string ReadRecording(const std::string& path)
{
    // O_NONBLOCK: opening a pipe without a writer would wait for one.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    struct stat status{};
    if (file.Number() < 0 || ::fstat(file.Number(), &status) != 0)
    {
        Refuse(path, std::string("it cannot be opened (") + std::strerror(errno) + ")", "a readable recording");
    }
    if (!S_ISREG(status.st_mode) || static_cast<std::uint64_t>(status.st_size) > kMostBytes)
    {
        Refuse(path, "it is no regular file of up to 2 GB", "a recording of candump -l, pcap or pcapng");
    }
    if (status.st_size == 0)
    {
        Refuse(path, "it is empty", "a recording of candump -l, pcap or pcapng");
    }
    std::string bytes(static_cast<std::size_t>(status.st_size), '\0');
    std::size_t count = 0U;
    while (count < bytes.size())
    {
        const ssize_t part = ::read(file.Number(), bytes.data() + count, bytes.size() - count);
        if (part <= 0)
        {
            break; // It became shorter: what was read is what there is.
        }
        count += static_cast<std::size_t>(part);
    }
    bytes.resize(count);
    return bytes;
}

std::unique_ptr<FrameSource> OpenRecording(const std::string& file, const std::string_view bytes,
                                           const RecordingOptions& options)
{
    const std::string_view magic = bytes.substr(0U, 4U);
    RefuseCompressed(file, magic);
    if (magic == "\x0A\x0D\x0D\x0A")
    {
        return std::make_unique<PcapngReader>(file, bytes, options);
    }
    const bool is_pcap = magic == "\xA1\xB2\xC3\xD4" || magic == "\xD4\xC3\xB2\xA1" || magic == "\xA1\xB2\x3C\x4D" ||
                         magic == "\x4D\x3C\xB2\xA1";
    if (is_pcap)
    {
        return std::make_unique<PcapReader>(file, bytes);
    }
    return std::make_unique<CandumpReader>(file, bytes, options);
}
} // namespace counterpoint::monitor
