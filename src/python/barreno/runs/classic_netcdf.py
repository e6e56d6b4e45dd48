# SPDX-License-Identifier: BSD-3-Clause
"""Whether a classic netCDF file has its end. The library reads zeros behind the end of a file that was cut off, so its size is compared
with what its header announces (NetCDF User's Guide, File Format Specifications: versions 1, 2 and 5)."""

import math
import os
import struct

from barreno.runs.regular_file import open_regular

SIZES = {1: 1, 2: 1, 3: 2, 4: 4, 5: 4, 6: 8, 7: 1, 8: 2, 9: 4, 10: 8, 11: 8}  # bytes of a value of each type
STREAMING = {4: 2**32 - 1, 8: 2**64 - 1}  # a number of records that was never written


class Header:
    """A reader of the parts of a header.  @param version  1, 2 or 5"""

    def __init__(self, stream, version):
        self.stream = stream
        self.count_bytes, self.offset_bytes = 8 if version == 5 else 4, 4 if version == 1 else 8

    def bytes(self, count):
        found = self.stream.read(count)
        if len(found) < count:
            raise ValueError("its header is cut off")
        return found

    def number(self, size):
        return struct.unpack(">I" if size == 4 else ">Q", self.bytes(size))[0]

    def count(self):
        return self.number(self.count_bytes)

    def padded(self, count):
        self.bytes(count + -count % 4)

    def entries(self, read):
        """A list: its tag, how many, and what `read` makes of each."""
        self.number(4)
        return [read() for _ in range(self.count())]

    def dimension(self):
        self.padded(self.count())
        return self.count()

    def attribute(self):
        self.padded(self.count())
        kind = self.number(4)
        self.padded(self.count() * SIZES[kind])

    def variable(self, lengths):
        """(whether it has a value for each record, bytes of one, begin)"""
        self.padded(self.count())
        dimensions = [self.count() for _ in range(self.count())]
        self.entries(self.attribute)
        in_records = bool(dimensions) and lengths[dimensions[0]] == 0
        size = SIZES[self.number(4)] * math.prod(lengths[one] for one in dimensions[in_records:])
        self.count()  # its size again, which has no room for that of a large one
        return in_records, size, self.number(self.offset_bytes)


def announced_size(stream):
    """Bytes that a file has at least by its header; 0 for another format, or while its number of records is unknown."""
    magic = stream.read(4)
    if magic[:3] != b"CDF" or magic[3:] not in (b"\1", b"\2", b"\5"):
        return 0
    header = Header(stream, magic[3])
    records = header.count()
    if records == STREAMING[header.count_bytes]:
        return 0
    lengths = header.entries(header.dimension)
    header.entries(header.attribute)
    variables = header.entries(lambda: header.variable(lengths))
    of_records = [size for in_records, size, _ in variables if in_records]
    step = of_records[0] if len(of_records) == 1 else sum(size + -size % 4 for size in of_records)
    ends = [begin + size + (step * (records - 1) if in_records else 0)
        for in_records, size, begin in variables if size and (records or not in_records)]
    return max(ends, default=0)


def refuse_cut(path):
    """@raises ValueError  if the end of the file is missing"""
    with open_regular(path, "rb") as stream:
        wanted, there = announced_size(stream), os.fstat(stream.fileno()).st_size
    if there < wanted:
        raise ValueError(f"its end is missing, {there} of {wanted} bytes are there")
