// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#include "canopen/cia306/text/text_file.hpp"

#include "canopen/cia306/text/input_error.hpp"

#include <cerrno>
#include <cstring>
#include <deque>
#include <fcntl.h>
#include <filesystem>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace counterpoint::cia306
{
namespace
{
constexpr std::size_t kBlockBytes = 65536U;
constexpr mode_t kNewFileMode = 0644;
constexpr int kMostLinks = 40;

class Descriptor
{
  public:
    explicit Descriptor(const int number) noexcept : number_(number)
    {
    }
    ~Descriptor()
    {
        (void)Close();
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    [[nodiscard]] int Number() const noexcept
    {
        return number_;
    }
    [[nodiscard]] bool Close() noexcept
    {
        const int number = number_;
        number_ = -1;
        return number < 0 || ::close(number) == 0;
    }

  private:
    int number_;
};

std::string ErrorText()
{
    return std::strerror(errno);
}

[[noreturn]] void Refuse(const std::string& path, const std::string& wrong, const std::string& expected)
{
    throw InputError(path, {}, {wrong, expected});
}

std::string KindOf(const mode_t mode)
{
    if (S_ISDIR(mode))
    {
        return "it is a directory";
    }
    if (S_ISFIFO(mode))
    {
        return "it is a pipe";
    }
    return (S_ISCHR(mode) || S_ISBLK(mode)) ? "it is a device" : "it is no regular file";
}

void RequireRegularAndSmall(const std::string& path, const struct stat& status)
{
    if (!S_ISREG(status.st_mode))
    {
        Refuse(path, KindOf(status.st_mode), "a regular file");
    }
    if (static_cast<std::uint64_t>(status.st_size) > kMaxFileBytes)
    {
        Refuse(path, "it has " + std::to_string(status.st_size) + " bytes",
               "at most " + std::to_string(kMaxFileBytes) + " bytes");
    }
}

std::string ReadAll(const std::string& path, const int descriptor)
{
    std::string text;
    std::string block(kBlockBytes, '\0');
    // Not the size that stat told: files of /proc have none, and a file may grow while it is read.
    while (text.size() <= kMaxFileBytes)
    {
        const ssize_t count = ::read(descriptor, block.data(), block.size());
        if (count == 0)
        {
            return text;
        }
        if (count < 0 && errno != EINTR)
        {
            Refuse(path, "it cannot be read (" + ErrorText() + ")", "a readable file");
        }
        text.append(block, 0U, count < 0 ? 0U : static_cast<std::size_t>(count));
    }
    Refuse(path, "it has more than " + std::to_string(kMaxFileBytes) + " bytes", "at most that many");
}

void WriteAll(const std::string& path, const int descriptor, std::string_view text)
{
    while (!text.empty())
    {
        const ssize_t count = ::write(descriptor, text.data(), text.size());
        if (count < 0 && errno != EINTR)
        {
            Refuse(path, "it cannot be written (" + ErrorText() + ")", "a file system with room");
        }
        text.remove_prefix(count < 0 ? 0U : static_cast<std::size_t>(count));
    }
}

/// Of what is replaced; it refuses to replace what is no regular file.
struct Keeping
{
    mode_t mode;
    uid_t owner; ///< -1: the file is new.
    gid_t group;
};

/// What this program prints would go into the file that is replaced, and be lost with it. [SRS_CLI_170]
void RequireNoOwnOutput(const std::string& path, const struct stat& status)
{
    for (const int own : {STDOUT_FILENO, STDERR_FILENO})
    {
        struct stat output{};
        const bool is_open = ::fstat(own, &output) == 0;
        if (is_open && output.st_dev == status.st_dev && output.st_ino == status.st_ino)
        {
            Refuse(path, "this program prints into it", "another file");
        }
    }
}

/// What no file can be named is refused here, before anything is made for it. [SRS_CLI_240]
Keeping KeepingOf(const std::string& path)
{
    struct stat status{};
    if (::stat(path.c_str(), &status) != 0)
    {
        if (errno != ENOENT && errno != ELOOP) // A link in a circle has words of its own.
        {
            Refuse(path, "it cannot be created (" + ErrorText() + ")", "a path in a writable folder");
        }
        return {kNewFileMode, static_cast<uid_t>(-1), static_cast<gid_t>(-1)};
    }
    if (!S_ISREG(status.st_mode))
    {
        Refuse(path, KindOf(status.st_mode), "a regular file, or none");
    }
    RequireNoOwnOutput(path, status);
    return {status.st_mode & static_cast<mode_t>(07777), status.st_uid, status.st_gid};
}

std::string FolderOf(const std::string& target)
{
    const std::string folder = std::filesystem::path(target).parent_path().string();
    return folder.empty() ? "." : folder;
}

/// Begin of a name beside `target` that leaves room for a number behind it, however long the own one is.
std::string BesideOf(const std::string& target)
{
    constexpr std::size_t most = 200U;
    const std::filesystem::path path(target);
    return (path.parent_path() / path.filename().string().substr(0U, most)).string();
}

/// A new file beside `target`, without a name where the system can do that: a process that is killed leaves nothing.
/// Else its name is written into `temporary`.
int CreateBeside(const std::string& path, const std::string& target, std::string& temporary)
{
    int descriptor = ::open(FolderOf(target).c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
    if (descriptor < 0 && (errno == EOPNOTSUPP || errno == EISDIR || errno == EINVAL))
    {
        temporary = BesideOf(target) + ".XXXXXX";
        descriptor = ::mkostemp(temporary.data(), O_CLOEXEC);
    }
    if (descriptor < 0)
    {
        Refuse(path, "it cannot be created (" + ErrorText() + ")", "a path in a writable folder");
    }
    return descriptor;
}

void KeepOwner(const std::string& path, const int descriptor, const Keeping& keeping)
{
    if (::fchown(descriptor, keeping.owner, keeping.group) != 0)
    {
        Refuse(path, "its owner cannot be kept (" + ErrorText() + ")", "a file of your own, or none");
    }
}

/// The system takes the bit of the group away without a word from whoever is not in it.
void KeepMode(const std::string& path, const int descriptor, const Keeping& keeping)
{
    struct stat status{};
    if (::fchmod(descriptor, keeping.mode) != 0 || ::fstat(descriptor, &status) != 0)
    {
        Refuse(path, "it cannot be replaced (" + ErrorText() + ")", "a path in a writable folder");
    }
    const bool is_new = keeping.owner == static_cast<uid_t>(-1);
    if (!is_new && (status.st_mode & static_cast<mode_t>(07777)) != keeping.mode)
    {
        Refuse(path, "its mode cannot be kept", "a file of a group of your own, or none");
    }
}

/// Gives a file without a name one beside `target`.
bool Name(const int descriptor, const std::string& target, std::string& temporary)
{
    const std::string name = BesideOf(target) + "." + std::to_string(::getpid());
    const std::string own = "/proc/self/fd/" + std::to_string(descriptor);
    const bool is_named =
        !temporary.empty() || ::linkat(AT_FDCWD, own.c_str(), AT_FDCWD, name.c_str(), AT_SYMLINK_FOLLOW) == 0;
    temporary = (is_named && temporary.empty()) ? name : temporary;
    return is_named;
}

/// A text that lies whole beside its place, and takes it in one step. One that does not leaves nothing.
class Replacement
{
  public:
    explicit Replacement(const std::string& path)
        : path_(path), keeping_(KeepingOf(path)), target_(TargetOf(path)),
          file_(CreateBeside(path, target_, temporary_))
    {
    }
    ~Replacement()
    {
        (void)(temporary_.empty() ? 0 : ::unlink(temporary_.c_str()));
    }
    Replacement(const Replacement&) = delete;
    Replacement& operator=(const Replacement&) = delete;

    void Write(const std::string_view text) const
    {
        WriteAll(path_, file_.Number(), text);
    }
    /// All of it is written.
    void End() const
    {
        KeepOwner(path_, file_.Number(), keeping_); // Before the mode, of which a change of the owner takes bits away.
        KeepMode(path_, file_.Number(), keeping_);
        Require(::fsync(file_.Number()) == 0);
    }
    void TakePlace()
    {
        Require(Name(file_.Number(), target_, temporary_) && file_.Close() &&
                ::rename(temporary_.c_str(), target_.c_str()) == 0);
        temporary_.clear();
    }

  private:
    void Require(const bool is_done) const
    {
        if (!is_done)
        {
            Refuse(path_, "it cannot be replaced (" + ErrorText() + ")", "a path in a writable folder");
        }
    }

    std::string path_;
    Keeping keeping_;
    std::string target_;
    std::string temporary_; ///< Its name beside the target; empty: it has none yet, or no longer.
    Descriptor file_;
};
} // namespace

std::string ReadTextFile(const std::string& path)
{
    // O_NONBLOCK: opening a pipe without a writer would wait for one.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY));
    if (file.Number() < 0)
    {
        Refuse(path, "it cannot be opened (" + ErrorText() + ")", "a readable EDS or DCF file");
    }
    struct stat status{};
    if (::fstat(file.Number(), &status) != 0)
    {
        Refuse(path, "its status cannot be read (" + ErrorText() + ")", "a readable file");
    }
    RequireRegularAndSmall(path, status);
    return ReadAll(path, file.Number());
}

std::string TargetOf(const std::string& path)
{
    std::filesystem::path target(path);
    std::error_code error;
    for (int i = 0; i < kMostLinks && std::filesystem::is_symlink(target, error); ++i)
    {
        target = target.parent_path() / std::filesystem::read_symlink(target, error);
    }
    if (std::filesystem::is_symlink(target, error))
    {
        Refuse(path, "it is a link in a circle", "a file, or a link to one");
    }
    return target.string();
}

void RequireWritable(const std::string& path)
{
    if (path.empty()) // A file beside it can be made, and not take its place.
    {
        Refuse(path, "it has no name", "the name of a file");
    }
    const Keeping keeping = KeepingOf(path);
    std::string temporary;
    const Descriptor file(CreateBeside(path, TargetOf(path), temporary));
    (void)(temporary.empty() ? 0 : ::unlink(temporary.c_str()));
    KeepOwner(path, file.Number(), keeping);
    KeepMode(path, file.Number(), keeping);
}

void WriteTextFile(const std::string& path, const std::string_view text)
{
    Replacement file(path);
    file.Write(text);
    file.End();
    file.TakePlace();
}

void WriteTextInPieces(const std::string& path, const std::function<void(const TextPiece&)>& write)
{
    Replacement file(path);
    std::string block; // Pieces are short.
    write(
        [&file, &block](const std::string_view piece)
        {
            block.append(piece);
            if (block.size() >= kBlockBytes)
            {
                file.Write(block);
                block.clear();
            }
        });
    file.Write(block);
    file.End();
    file.TakePlace();
}

void WriteTextFiles(const std::vector<NamedText>& texts)
{
    std::deque<Replacement> files;
    for (const NamedText& each : texts)
    {
        const Replacement& file = files.emplace_back(each.path);
        file.Write(each.text);
        file.End();
    }
    for (Replacement& file : files)
    {
        file.TakePlace();
    }
}
} // namespace counterpoint::cia306
