#!/usr/bin/env python3
"""Writes the models of the test scenes in scenes/models (icosahedron.obj, uv-sphere.ply, graticule.png, sky.exr) from their
formulas."""

import math
import pathlib
import struct
import zlib

MODELS = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "models"


def write_icosahedron(path):
    """Twelve corners, (0, +-1, +-phi) and its rotations, scaled to the unit sphere; no normals, for flat shading."""
    phi = (1 + math.sqrt(5)) / 2
    corners = []
    for a in (-1, 1):
        for b in (-phi, phi):
            corners += [(0, a, b), (a, b, 0), (b, 0, a)]
    # Neighbours are 2 apart; three mutual neighbours form a face, ordered counter-clockwise from outside.
    faces = []
    for i in range(12):
        for j in range(i + 1, 12):
            for k in range(j + 1, 12):
                sides = [math.dist(corners[m], corners[n]) for m, n in ((i, j), (j, k), (k, i))]
                if all(abs(side - 2) < 1e-9 for side in sides):
                    u = [corners[j][x] - corners[i][x] for x in range(3)]
                    v = [corners[k][x] - corners[i][x] for x in range(3)]
                    normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
                    outward = sum(normal[x] * corners[i][x] for x in range(3)) > 0
                    faces.append((i, j, k) if outward else (i, k, j))
    assert len(faces) == 20
    radius = math.hypot(1, phi)
    lines = ["# Icosahedron in the unit sphere, made by scripts/make-test-models.py"]
    lines += ["v %.9f %.9f %.9f" % tuple(x / radius for x in corner) for corner in corners]
    lines += ["f %d %d %d" % tuple(i + 1 for i in face) for face in faces]
    path.write_text("\n".join(lines) + "\n")


def write_uv_sphere(path, rings=12, sectors=24):
    """Unit sphere of quadrilaterals, with triangles at the poles; normals equal positions. Binary, little endian."""
    vertices = [(0.0, 1.0, 0.0)]
    for ring in range(1, rings):
        theta = math.pi * ring / rings
        for sector in range(sectors):
            phi = 2 * math.pi * sector / sectors
            point = (math.sin(theta) * math.cos(phi), math.cos(theta), math.sin(theta) * math.sin(phi))
            # Rounded, so that the file does not depend on the machine's libm.
            vertices.append(tuple(round(x, 7) + 0.0 for x in point))
    vertices.append((0.0, -1.0, 0.0))
    last = len(vertices) - 1

    def at(ring, sector):
        return 1 + (ring - 1) * sectors + sector % sectors

    faces = []
    for sector in range(sectors):
        faces.append((0, at(1, sector + 1), at(1, sector)))
        for ring in range(1, rings - 1):
            faces.append((at(ring, sector), at(ring, sector + 1), at(ring + 1, sector + 1), at(ring + 1, sector)))
        faces.append((last, at(rings - 1, sector), at(rings - 1, sector + 1)))

    header = ["ply", "format binary_little_endian 1.0",
              "comment unit sphere with smooth normals, made by scripts/make-test-models.py",
              f"element vertex {len(vertices)}"]
    header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
    header += [f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header"]
    body = b"".join(struct.pack("<6f", *vertex, *vertex) for vertex in vertices)
    body += b"".join(struct.pack(f"<B{len(face)}i", len(face), *face) for face in faces)
    path.write_bytes("\n".join(header).encode() + b"\n" + body)


def write_graticule(path, width=96, height=48):
    """A globe map: sea that darkens towards the poles, a bright line every 45 degrees, and a red equator."""
    rows = []
    for y in range(height):
        row = bytearray([0])  # filter: none
        for x in range(width):
            sea = 150 - 100 * abs(2 * y + 1 - height) // height
            color = (40, sea, 200)
            if x % (width // 8) == 0 or y % (height // 4) == 0:
                color = (240, 235, 210)
            if y in (height // 2 - 1, height // 2):
                color = (220, 40, 30)
            row += bytes(color)
        rows.append(bytes(row))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(b"".join(rows), 9))
                     + chunk(b"IEND", b""))
def write_sky(path, width=32, height=16):
    """Equirectangular sky in uniform steps, brighter at the horizon, with a sun of four pixels and dim ground: an
    uncompressed EXR file of 32-bit floats."""
    def color(x, y):
        if y >= height // 2:
            return 0.08, 0.06, 0.05
        if y in (3, 4) and x in (20, 21):
            return 14, 12, 9
        haze = (y + 0.5) / (height // 2)
        return 0.15 + 0.25 * haze, 0.25 + 0.25 * haze, 0.5 + 0.15 * haze

    def attribute(name, kind, data):
        return name.encode() + b"\0" + kind.encode() + b"\0" + struct.pack("<i", len(data)) + data

    channels = b"".join(name + b"\0" + struct.pack("<iiii", 2, 0, 1, 1) for name in (b"B", b"G", b"R")) + b"\0"
    window = struct.pack("<4i", 0, 0, width - 1, height - 1)
    header = struct.pack("<ii", 20000630, 2)
    header += attribute("channels", "chlist", channels) + attribute("compression", "compression", b"\0")
    header += attribute("dataWindow", "box2i", window) + attribute("displayWindow", "box2i", window)
    header += attribute("lineOrder", "lineOrder", b"\0") + attribute("pixelAspectRatio", "float", struct.pack("<f", 1))
    header += attribute("screenWindowCenter", "v2f", struct.pack("<ff", 0, 0))
    header += attribute("screenWindowWidth", "float", struct.pack("<f", 1)) + b"\0"
    rows = []
    for y in range(height):
        pixels = [color(x, y) for x in range(width)]
        samples = b"".join(struct.pack("<f", pixel[c]) for c in (2, 1, 0) for pixel in pixels)
        rows.append(struct.pack("<ii", y, len(samples)) + samples)
    first = len(header) + 8 * height
    offsets = b"".join(struct.pack("<Q", first + y * len(rows[0])) for y in range(height))
    path.write_bytes(header + offsets + b"".join(rows))


MODELS.mkdir(parents=True, exist_ok=True)
write_icosahedron(MODELS / "icosahedron.obj")
write_uv_sphere(MODELS / "uv-sphere.ply")
write_graticule(MODELS / "graticule.png")
write_sky(MODELS / "sky.exr")
