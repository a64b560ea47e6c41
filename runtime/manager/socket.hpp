// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_SOCKET_HPP
#define RUNTIME_MANAGER_SOCKET_HPP

#include "hal/host/live/poll.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <poll.h>
#include <sys/stat.h>

namespace counterpoint::runtime
{
constexpr mode_t kOwnerOnly = 0600;
constexpr mode_t kOwnerAndGroup = 0660;

/// How long a client may take nothing of an answer that waits for it.
constexpr std::uint64_t kAnswerPatienceNs = 2'000'000'000U;

/// A Unix socket on which programs send orders, a line each, and read the answers. Nothing blocks: of a client whose
/// answer waits no further line is taken, one that takes nothing of it for long is disconnected, and a new client takes
/// the place of the one that was silent longest. Its end removes the socket file that it made, and no other one.
/// [SRS_MGR_006, SRS_MGR_061, SRS_MGR_137, SRS_MGR_138, SRS_MGR_160, SRS_MGR_471]
class ManagerSocket
{
  public:
    /// @brief Listens at `path`, for whom the bits of `mode` let write; replaces a socket file that nobody serves any
    /// more. Throws cia306::InputError.
    explicit ManagerSocket(std::string path, mode_t mode = kOwnerOnly, std::uint64_t patience_ns = kAnswerPatienceNs);
    ~ManagerSocket();
    ManagerSocket(const ManagerSocket&) = delete;
    ManagerSocket& operator=(const ManagerSocket&) = delete;

    /// @brief Adds the descriptors to wait for.
    void AddTo(std::vector<pollfd>& places) const;
    /// @brief Takes new clients, and of each client a few whole lines; `answer` gives the answer to a line, `cut` that
    /// to a line that the end of what a client sends has cut.
    void Serve(const std::function<std::string(const std::string&)>& answer,
               const std::function<std::string(const std::string&)>& cut = {});

  private:
    struct Client
    {
        host::LiveFile file;
        std::string typed;
        std::string unsent;         ///< Of its last answer.
        std::uint64_t taken_ns{0U}; ///< When it took some of that, or had to begin.
        bool is_ended{false};       ///< It sends nothing more.
        bool is_over{false};
        std::uint64_t heard{0U}; ///< Turn in which it said something.
    };

    void Accept();
    void Read(Client& client);
    void TakeLines(Client& client, const std::function<std::string(const std::string&)>& answer);
    void TakeRest(Client& client, const std::function<std::string(const std::string&)>& cut) const;
    void Send(Client& client) const;

    std::uint64_t patience_ns_;

    std::string path_;
    host::LiveFile listener_;
    struct stat made_ = {}; ///< The socket file.
    std::vector<Client> clients_;
    std::uint64_t turn_{0U};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_SOCKET_HPP
