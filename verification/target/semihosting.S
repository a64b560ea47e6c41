@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ What only assembly can ask of the emulator.
    .syntax unified
    .arch armv7-r
    .arm
    .section .text, "ax", %progbits

@ Word TargetTrap(operation, block): the semihosting trap of ARM state.
    .global TargetTrap
    .type TargetTrap, %function
TargetTrap:
    svc 0x123456
    bx lr

@ The performance monitor's cycle counter. The emulator counts with `-icount shift=0`: one executed instruction, one cycle.
    .global TargetStartCycles
    .type TargetStartCycles, %function
TargetStartCycles:
    mov r0, #5                         @ enable, reset the cycle counter
    mcr p15, 0, r0, c9, c12, 0
    mov r0, #0x80000000
    mcr p15, 0, r0, c9, c12, 1
    bx lr

    .global TargetReadCycles
    .type TargetReadCycles, %function
TargetReadCycles:
    mrc p15, 0, r0, c9, c13, 0
    bx lr
    .section .note.GNU-stack, "", %progbits
    .end
