# SPDX-License-Identifier: BSD-3-Clause
"""The seal of a checkpoint (src/checkpoint/seal.cpp): length and CRC-32 of all bytes behind the user block, in it."""
import zlib

USER_BLOCK = 512


def reseal(path):
    """After this the file's bytes are what a checkpoint would have had written."""
    data = bytearray(path.read_bytes())
    body = bytes(data[USER_BLOCK:])
    seal = f"barreno checkpoint\nbytes {len(body)}\ncrc32 {zlib.crc32(body):08x}\n".encode()
    data[:USER_BLOCK] = seal.ljust(USER_BLOCK, b"\0")
    path.write_bytes(data)
