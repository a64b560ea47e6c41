// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_MACHINE_HPP
#define VERIFICATION_INJECTION_MACHINE_HPP

#include "verification/injection/digest.hpp"
#include "verification/injection/image/mailbox.hpp"
#include "verification/injection/outside.hpp"
#include "verification/injection/program.hpp"
#include "verification/injection/ram.hpp"
#include "verification/injection/registers.hpp"

#include <cstdint>
#include <vector>

struct uc_context;

namespace counterpoint::injection
{

/// Between two steps, or before an instruction of a step.
struct Snapshot
{
    std::vector<std::uint8_t> ram{};
    Registers registers{};
    uc_context* context{nullptr};
    Outside outside{};
    std::vector<std::uint8_t> mail{};
    std::uint32_t count{0U};
    std::uint32_t stopped{0U};
};

enum class FaultKind : std::uint8_t
{
    kNone,
    kSkip,
    kInvert,
    kRegister, ///< One bit, before the instruction that reads it.
    kOpcode,   ///< One bit of the instruction, for one execution.
    kMemory,   ///< One bit of RAM, before the step: it stays until it is written.
    kStuck,    ///< One bit of RAM reads as 0 or as 1 from the step on.
    kFlash,    ///< One bit of the code, from the step on.
};

/// One fault in one step.
struct Fault
{
    FaultKind kind{FaultKind::kNone};
    std::uint32_t count{0U};   ///< Instruction of the step, from 0.
    std::uint32_t address{0U}; ///< Of the instruction, or of the byte.
    std::uint32_t number{0U};  ///< Bit; with kRegister 32 * register + bit; with kStuck 8 * value + bit.
};

/// The emulated processor with the image, and what is around it.
class Machine
{
  public:
    explicit Machine(const Program& program);
    ~Machine();
    Machine(const Machine&) = delete;
    Machine& operator=(const Machine&) = delete;

    /// @brief From reset up to before the first step. Throws std::runtime_error where that fails.
    void Start();
    /// @brief One step without a fault; stuck bits and changed code stay.
    Seen Step(const Mailbox& mail);
    /// @brief The same; the addresses of its instructions are appended.
    Seen Trace(const Mailbox& mail, std::vector<std::uint32_t>& trace);
    /// @brief The same; what it does with RAM is noted.
    Seen Note(const Mailbox& mail, Accesses& accesses);
    /// @brief A step begins; it goes on up to before its instruction `count`, and Finish ends it.
    void Begin(const Mailbox& mail);
    void WalkTo(std::uint32_t count);
    Seen Finish(const Fault& fault);

    void Save(Snapshot& to);
    void Restore(const Snapshot& from);
    /// @brief Whether everything that lives is as it was then.
    [[nodiscard]] bool Equals(const Snapshot& other);
    /// @brief Adds everything that lives.
    void Add(Digest& to);
    /// @brief Inverts a bit of the code that Step runs, until it is inverted again.
    void FlipCode(std::uint32_t address, std::uint32_t bit);
    /// @brief Between two steps; Restore ends what is stuck.
    [[nodiscard]] Ram& Memory()
    {
        return ram_;
    }

  private:
    friend struct MachineCalls;

    void Map(uc_struct* engine);
    void OnInstruction(std::uint32_t address);
    void OnBlock(std::uint32_t address);
    void StopAt(std::uint32_t address);
    void Use(uc_struct* engine);
    [[nodiscard]] bool Run(std::uint32_t from);
    [[nodiscard]] bool RunFaulted(const Fault& fault);
    [[nodiscard]] bool RunPatched(const Fault& fault);
    [[nodiscard]] bool RunOn(std::uint32_t from);
    [[nodiscard]] bool IsOver() const;
    void Patch(const Fault& fault);
    [[nodiscard]] std::uint32_t Caller();
    [[nodiscard]] Seen Conclude(bool is_running);
    void Fill(const Mailbox& mail);

    const Program& program_;
    uc_struct* watched_{nullptr}; ///< Stops at any instruction.
    uc_struct* fast_{nullptr};    ///< The same memory, for what has no fault; stops at blocks.
    uc_struct* reading_{nullptr}; ///< The same, and looks at each read.
    uc_struct* engine_{nullptr};  ///< The one that has the state.
    uc_context* started_[2]{};    ///< Of `fast_` and `reading_`: a crash leaves other modes behind.
    std::uint32_t mode_{0U};      ///< Of the processor, in CPSR.
    std::uint32_t step_end_;
    std::uint32_t ram_begin_;
    Ram ram_;
    std::uint8_t* code_{nullptr};
    std::uint8_t* mail_{nullptr};

    Outside outside_{};
    std::vector<std::uint32_t>* trace_{nullptr};
    std::uint32_t count_{0U};
    std::uint32_t stop_at_{0U};
    std::uint32_t register_{0U}; ///< Where a bit of a register is inverted within a block: its number.
    bool is_walking_{false};     ///< Stops at `stop_at_`; otherwise inverts the bit there.
    std::uint32_t most_{0U};
    Range patched_{0U, 0U}; ///< Leaving it stops.
    std::uint32_t stopped_{0U};
    bool is_stopped_{false};
};

} // namespace counterpoint::injection

#endif
