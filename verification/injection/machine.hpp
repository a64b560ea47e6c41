// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_INJECTION_MACHINE_HPP
#define VERIFICATION_INJECTION_MACHINE_HPP

#include "verification/injection/image/mailbox.hpp"
#include "verification/injection/program.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

struct uc_struct;
struct uc_context;

namespace counterpoint::injection
{

/// A frame that the image has sent.
struct SentFrame
{
    std::uint32_t identifier;
    std::uint32_t length_bytes;
    std::uint32_t first;
    std::uint32_t second;

    bool operator==(const SentFrame& other) const
    {
        return (identifier == other.identifier) && (length_bytes == other.length_bytes) && (first == other.first) &&
               (second == other.second);
    }
};

/// Values of an object and of its inverse one.
struct ObjectPair
{
    std::uint32_t normal;
    std::uint32_t inverse;
};

enum class StepEnd : std::uint8_t
{
    kDone,
    kException, ///< Access, instruction or call that the processor refuses.
    kRunaway,   ///< Many times as long as without a fault: the watchdog is not answered.
};

/// What a step showed outside.
struct Seen
{
    StepEnd end{StepEnd::kDone};
    std::uint32_t pins{0U}; ///< High at the end of the step.
    std::uint32_t refused{0U};
    std::uint32_t device_fault{0U};
    std::uint32_t answer{0U};
    bool is_answered{false};
    bool is_cut_off{false};
    std::vector<SentFrame> sent{};
    std::vector<std::uint32_t> events{};
    std::array<ObjectPair, 3> objects{};
};

/// What the image has outside of RAM and processor: pins, and frames on their way.
struct World
{
    std::uint32_t direction[2]{};
    std::uint32_t output[2]{};
    bool is_error_pin_low{false};
    std::vector<SentFrame> pending{};

    bool operator==(const World& other) const
    {
        return (direction[0] == other.direction[0]) && (direction[1] == other.direction[1]) &&
               (output[0] == other.output[0]) && (output[1] == other.output[1]) &&
               (is_error_pin_low == other.is_error_pin_low) && (pending == other.pending);
    }
};

/// Registers that a call keeps, stack pointer and the place to go on.
struct Registers
{
    std::array<std::uint32_t, 10> words{}; ///< r4 to r11, sp, pc
    std::array<std::uint64_t, 8> doubles{};

    bool operator==(const Registers& other) const
    {
        return (words == other.words) && (doubles == other.doubles);
    }
};

/// Between two steps.
struct Snapshot
{
    std::vector<std::uint8_t> ram{};
    Registers registers{};
    uc_context* context{nullptr};
    World world{};
};

enum class FaultKind : std::uint8_t
{
    kNone,
    kSkip,
    kInvert,
    kRegister, ///< One bit, before the instruction that reads it.
    kMemory,   ///< One bit of RAM, before the step.
};

/// One fault in one step.
struct Fault
{
    FaultKind kind{FaultKind::kNone};
    std::uint32_t count{0U};   ///< Instruction of the step, from 0.
    std::uint32_t address{0U}; ///< Of the instruction, or of the byte of RAM.
    std::uint32_t number{0U};  ///< Bit; with kRegister 32 * register + bit.
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
    /// @brief One step. With a trace: the addresses of its instructions are appended.
    Seen Step(const Mailbox& mail, const Fault& fault, std::vector<std::uint32_t>* trace);

    void Save(Snapshot& to);
    void Restore(const Snapshot& from);
    /// @brief Whether everything that lives is as it was then.
    [[nodiscard]] bool Equals(const Snapshot& other);
    /// @brief Inverts a bit of RAM between two steps.
    void FlipMemory(std::uint32_t address, std::uint32_t bit);
    void WriteObjects(std::uint32_t object, const ObjectPair& values);
    [[nodiscard]] std::array<ObjectPair, 3> Objects();

  private:
    friend struct MachineCalls;

    void Map(uc_struct* engine);
    void OnInstruction(std::uint32_t address);
    void OnBlock(std::uint32_t address);
    void StopAt(std::uint32_t address);
    [[nodiscard]] std::uint32_t ReadPort(std::uint32_t address) const;
    void WritePort(std::uint32_t address, std::uint32_t value);
    void WritePin(std::uint32_t offset, std::uint32_t value);
    void Use(uc_struct* engine);
    [[nodiscard]] bool Run(std::uint32_t from);
    [[nodiscard]] bool RunFaulted(std::uint32_t from);
    [[nodiscard]] bool RunPatched(std::uint32_t patched, std::uint32_t block_end);
    [[nodiscard]] Registers ReadRegisters();
    void Fill(const Mailbox& mail);
    void Look();
    [[nodiscard]] std::uint8_t* Ram(std::uint32_t address);

    const Program& program_;
    uc_struct* watched_{nullptr}; ///< Stops at any instruction.
    uc_struct* fast_{nullptr};    ///< The same memory, for steps without a fault; stops at blocks.
    uc_struct* engine_{nullptr};  ///< The one of both that has the state.
    std::uint32_t cpsr_{0U};      ///< Of `fast_` after the start: a crash leaves other modes behind.
    std::uint32_t fpscr_{0U};
    std::uint32_t step_end_;
    std::uint32_t places_;
    std::uint32_t ram_begin_;
    std::uint32_t ram_live_;
    std::uint32_t stack_top_;
    std::uint8_t* code_{nullptr};
    std::uint8_t* ram_{nullptr};
    std::uint32_t ram_bytes_{0U};
    std::uint8_t* mail_{nullptr};

    World world_{};
    Seen seen_{};
    SentFrame sending_{};
    std::vector<std::uint32_t>* trace_{nullptr};
    Fault fault_{};
    std::uint32_t count_{0U};
    std::uint32_t stop_at_{0U};
    std::uint32_t most_{0U};
    Range patched_{0U, 0U}; ///< Leaving it stops.
    std::uint32_t stopped_{0U};
    bool is_stopped_{false};
};

/// @brief The IT instruction whose block has the instruction number `count` of the trace; `count` itself where none.
[[nodiscard]] std::uint32_t FindBlock(const Program& program, const std::vector<std::uint32_t>& trace,
                                      std::uint32_t count);
/// @brief Whether the instruction decides: a conditional branch or an IT.
[[nodiscard]] bool IsDecision(const Program& program, std::uint32_t address);

} // namespace counterpoint::injection

#endif
