@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ The RAM is written with zeroes and a right ECC by the hardware of the system module (TRM "auto-initialisation of
@ on-chip RAM"): global key, memory 1 (RAM), wait for the end, global key off.
    .syntax unified
    .arch armv7-r
    .arm

    .equ .Lsystem, 0xFFFFFF00
    .equ .Lminitgcr, 0x5C
    .equ .Lmsinena, 0x60
    .equ .Lmstcgstat, 0x68
    .equ .Lkey_on, 0xA
    .equ .Lkey_off, 0x5
    .equ .Lram, 1
    .equ .Lerror_key, 0xFFFFF538       @ ESMEKR; its key to force is the same
    .equ .Ldone, 1 << 8
    .equ .Lmost_looks, 0x10000         @ the hardware takes one cycle for a word of 64 bits: 64 Ki of them at the most

    .section .text.start_up, "ax", %progbits
    .global HardwareInitialiseRam
    .type HardwareInitialiseRam, %function
HardwareInitialiseRam:
    ldr r1, =.Lsystem
    mov r0, #.Lkey_on
    str r0, [r1, #.Lminitgcr]
    mov r0, #.Lram
    str r0, [r1, #.Lmsinena]
    ldr r2, =.Lmost_looks
1:  ldr r0, [r1, #.Lmstcgstat]
    ands r0, r0, #.Ldone
    bne 2f
    subs r2, r2, #1
    bne 1b
2:  mov r3, #.Lkey_off
    str r3, [r1, #.Lminitgcr]
    cmp r0, #0                         @ the caller stands still then: nERROR low, or nobody outside would know
    ldreq r1, =.Lerror_key
    moveq r2, #.Lkey_on
    streq r2, [r1]
    bx lr                              @ r0: 0 if every look was in vain
    .size HardwareInitialiseRam, . - HardwareInitialiseRam
    .ltorg
    .section .note.GNU-stack, "", %progbits
    .end
