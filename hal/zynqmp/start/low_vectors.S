@ Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
@
@ Vectors of a board: each processor has its own A-TCM at 0, where its image begins. The boot loader may have left the
@ vectors at FFFF0000h. [SRS_ZYN_003]
    .syntax unified
    .arch armv7-r
    .arm

    .section .text.start_up, "ax", %progbits
    .global HardwareSetVectors
    .type HardwareSetVectors, %function
HardwareSetVectors:
    mrc p15, 0, r0, c1, c0, 0
    bic r0, r0, #1 << 13               @ SCTLR.V
    mcr p15, 0, r0, c1, c0, 0
    isb
    bx lr
    .size HardwareSetVectors, . - HardwareSetVectors
    .section .note.GNU-stack, "", %progbits
    .end
