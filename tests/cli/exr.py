"""Reads the EXR files that hyalite writes, from the published file layout, so that tests of pixel values do not depend on the program's own reader: one part of scan lines, 32-bit float channels, ZIP compression or none.
"""

import array
import math
import struct
import sys
import zlib

MAGIC = b"\x76\x2f\x31\x01"
LINES_PER_BLOCK = {0: 1, 3: 16}  # by compression: none, ZIP
FLOAT = 2


def text_at(data, position):
    end = data.index(b"\0", position)
    return data[position:end].decode(), end + 1


def read_header(data):
    """Attributes by name as bytes, and the end of the header."""
    assert data[:4] == MAGIC, "not an EXR file"
    assert struct.unpack_from("<I", data, 4)[0] & ~0xFF == 0, "tiled, deep, multi-part or with long names"
    attributes, position = {}, 8
    while data[position] != 0:
        name, position = text_at(data, position)
        _, position = text_at(data, position)
        (size,) = struct.unpack_from("<i", data, position)
        attributes[name] = data[position + 4 : position + 4 + size]
        position += 4 + size
    return attributes, position + 1


def channel_names(attribute):
    names, position = [], 0
    while attribute[position] != 0:
        name, position = text_at(attribute, position)
        kind, _, x_sampling, y_sampling = struct.unpack_from("<iIii", attribute, position)
        assert (kind, x_sampling, y_sampling) == (FLOAT, 1, 1), name
        names.append(name)
        position += 16
    return names


def unzip(block, size):
    """OpenEXR's ZIP: deflated byte differences, all even bytes first. Data that would not shrink is stored raw."""
    if len(block) == size:
        return block
    encoded = zlib.decompress(block)
    assert len(encoded) == size
    plain, value = bytearray(size), 0
    for index, step in enumerate(encoded):
        value = (value + step - (128 if index > 0 else 0)) & 0xFF
        plain[index] = value
    halves = bytearray(size)
    half = (size + 1) // 2
    halves[0::2], halves[1::2] = plain[:half], plain[half:]
    return bytes(halves)


class Picture:
    """Channel name -> list of rows of floats, row 0 at the top. `layer`: the one whose pixels at() returns."""

    def __init__(self, path, layer=""):
        self.layer = layer + "." if layer else ""
        data = path.read_bytes()
        attributes, position = read_header(data)
        x0, y0, x1, y1 = struct.unpack("<4i", attributes["dataWindow"])
        self.width, self.height = x1 - x0 + 1, y1 - y0 + 1
        compression = attributes["compression"][0]
        lines = LINES_PER_BLOCK[compression]
        names = channel_names(attributes["channels"])
        self.channels = {name: [None] * self.height for name in names}
        blocks = -(-self.height // lines)
        for (offset,) in struct.iter_unpack("<Q", data[position : position + 8 * blocks]):
            y, size = struct.unpack_from("<ii", data, offset)
            count = min(lines, self.height - (y - y0))
            block = data[offset + 8 : offset + 8 + size]
            self._add_lines(y - y0, names, unzip(block, 4 * count * self.width * len(names)))

    def _add_lines(self, y, names, block):
        values = array.array("f", block)
        if sys.byteorder == "big":
            values.byteswap()
        for start in range(0, len(values), self.width):
            line, channel = divmod(start // self.width, len(names))
            self.channels[names[channel]][y + line] = values[start : start + self.width].tolist()

    def at(self, x, y):
        """(R, G, B)."""
        return tuple(self.channels[self.layer + name][y][x] for name in "RGB")

    def values(self):
        return [value for name in "RGB" for row in self.channels[self.layer + name] for value in row]

    def is_finite(self):
        return all(map(math.isfinite, self.values()))
