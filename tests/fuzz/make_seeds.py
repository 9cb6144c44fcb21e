"""Writes the fuzzers' seeds into FOLDER, one folder per fuzzer: small valid files of every kind, and the beginnings of
hostile ones (billions of elements, endless nesting, wild offsets)."""

import base64
import json
import pathlib
import struct
import sys
import zlib

TRIANGLE = [(0, 0, 0), (1, 0, 0), (0, 1, 0)]


def ply_seeds():
    header = ("ply\nformat {} 1.0\ncomment seed\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
              "element face 1\nproperty list uchar int vertex_indices\nend_header\n")
    yield header.format("ascii").encode() + b"0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    for order, mark in (("binary_little_endian", "<"), ("binary_big_endian", ">")):
        body = b"".join(struct.pack(mark + "3f", *corner) for corner in TRIANGLE) + struct.pack(mark + "B3i", 3, 0, 1, 2)
        yield header.format(order).encode() + body
    yield header.format("ascii").replace("vertex 3", "vertex 1000000000").encode()
    yield header.format("binary_little_endian").replace("float x", "list uint double x").encode() + b"\xff" * 40
    yield header.format("binary_little_endian").replace("face 1", "empty 1000000000000\nelement face 1").encode()


def stl_seeds():
    corners = "".join(f"vertex {x} {y} {z}\n" for x, y, z in TRIANGLE)
    yield f"solid a\nfacet normal 0 0 1\nouter loop\n{corners}endloop\nendfacet\nendsolid a\n".encode()
    facet = struct.pack("<12f", 0, 0, 1, *sum(TRIANGLE, ())) + b"\0\0"
    yield bytes(80) + struct.pack("<I", 1) + facet
    yield bytes(80) + struct.pack("<I", 0xFFFFFFFF) + facet


def obj_seeds():
    yield b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 -1/-1/-1\n"
    yield b"v 0 0 0 1 # w\nv 1e308 0 0\nv 0 1 0\\\n\ng a\nusemtl b\ns 1\nf 1 2 3 1\nf 999999999999 1 2\n"


def gltf_document(**changes):
    positions = b"".join(struct.pack("<3f", *corner) for corner in TRIANGLE)
    buffer = positions + struct.pack("<3H", 0, 1, 2)
    document = {
        "asset": {"version": "2.0"},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "translation": [1, 2, 3]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1], "roughnessFactor": 0.5}}],
        "buffers": [{"byteLength": len(buffer)}],
        "bufferViews": [{"buffer": 0, "byteLength": len(positions)},
                        {"buffer": 0, "byteOffset": len(positions), "byteLength": 6}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
                      {"bufferView": 1, "componentType": 5123, "count": 3, "type": "SCALAR"}],
    }
    return {**document, **changes}, buffer


def gltf_seeds():
    def embedded(document, buffer):
        document["buffers"][0]["uri"] = "data:application/octet-stream;base64," + base64.b64encode(buffer).decode()
        return json.dumps(document).encode()

    yield embedded(*gltf_document())
    document, buffer = gltf_document()
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    data = buffer + bytes(-len(buffer) % 4)
    chunks = struct.pack("<I4s", len(text), b"JSON") + text + struct.pack("<I4s", len(data), b"BIN\0") + data
    yield struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks
    # Wild offsets, billions of elements, a sparse accessor, a node that is its own child, a file elsewhere
    wild, buffer = gltf_document()
    wild["bufferViews"][0]["byteOffset"] = 2**63
    yield embedded(wild, buffer)
    large, buffer = gltf_document()
    large["accessors"][0] = {"componentType": 5126, "count": 10**9, "type": "VEC3",
                             "sparse": {"count": 1, "indices": {"bufferView": 1, "componentType": 5123},
                                        "values": {"bufferView": 0}}}
    yield embedded(large, buffer)
    yield embedded(*gltf_document(nodes=[{"mesh": 0, "children": [0]}]))
    outside, _ = gltf_document(buffers=[{"byteLength": 42, "uri": "../../etc/passwd"}])
    yield json.dumps(outside).encode()
    yield b"[" * 10000


def scene_seeds():
    lines = ["hyalite: 1", "camera: {position: [0, 0, 4], resolution: [8, 8]}", "materials: {gray: {type: diffuse}}",
             "lights: [{type: point, position: [0, 1, 2]}]",
             "objects: [{shape: {type: sphere, radius: 1}, material: gray}]"]
    yield "\n".join(lines).encode()
    yield "\n".join(lines[:-1] + ["objects:", "- {shape: {type: mesh, file: ../../../etc/passwd}, material: gray}"]).encode()
    yield "\n".join(lines[:-1] + ["objects:", "- shape: {type: sphere}", "  material: gray", "  repeat:",
                                  "  - {count: 2000, transform: [{translate: [1, 0, 0]}]}"]).encode()
    # Endless nesting, aliases of aliases, a value that contains itself
    yield b"[" * 10000
    yield b"{a: " * 5000
    yield b"a: &a [x, x, x]\n" + b"".join(
        f"{chr(98 + i)}: &{chr(98 + i)} [{', '.join(['*' + chr(97 + i)] * 9)}]\n".encode() for i in range(9))
    yield b"a: &a [*a]\n"


def png(width, height, lines, kind=2):
    def chunk(name, data):
        return struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
    head = struct.pack(">IIBBBBB", width, height, 8, kind, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", zlib.compress(lines)) + chunk(b"IEND", b"")


def image_seeds():
    yield png(2, 2, b"\0\1\2\3\4\5\6" * 2)
    yield png(2, 1, b"\1\7\7", kind=0)
    yield png(65536, 65536, b"\0")
    # A minimal JPEG: one block of 8 x 8, one Huffman code of each kind
    table = b"\xff\xdb\0\x43\0" + b"\1" * 64
    frame = b"\xff\xc0\0\x0b\x08\0\x08\0\x08\1\1\x11\0"
    codes = b"\xff\xc4\0\x14\0" + b"\1" + bytes(15) + b"\0" + b"\xff\xc4\0\x14\x10" + b"\1" + bytes(15) + b"\0"
    yield b"\xff\xd8" + table + frame + codes + b"\xff\xda\0\x08\1\1\0\0\x3f\0" + b"\x3f" + b"\xff\xd9"
    models = pathlib.Path(__file__).parents[2] / "scenes/models"
    yield (models / "sky.exr").read_bytes()
    yield (models / "graticule.png").read_bytes()


def checkpoint_seeds():
    """Without the checksum: the fuzzer appends it."""
    def checkpoint(width, height, ranges=((0, 2),), layers=1, words=1):
        text = b"scene a.yaml\n" + b"layer light 1\n" * layers + b"set integrator=ppm\nset render.seed=1\ncount camera_rays=7\n"
        header = struct.pack("<8sIIIIIId", b"hyachkp2", width, height, layers, len(ranges), len(text), 0, 1.5)
        faults = struct.pack("<QII", 0, 0, 0) * 4 * layers
        plane = struct.pack("<I", words) + struct.pack(f"<{3 * width * height}I", *range(3 * width * height)) * words
        return header + text + b"".join(struct.pack("<II", *r) for r in ranges) + faults + plane * 2 * layers

    yield checkpoint(2, 1)
    yield checkpoint(1, 1, ranges=((0, 1), (5, 9)), layers=2)
    yield checkpoint(1, 1)[:8] + struct.pack("<II", 0xFFFFFFFF, 0xFFFFFFFF) + checkpoint(1, 1)[16:]


def photons_seeds():
    photon = bytes(32)
    yield struct.pack("<8sQ3Q", b"hyaphot2", 0, 1, 1, 0) + photon * 2
    yield struct.pack("<8sQ3Q", b"hyaphot2", 0, 2**61, 0, 0) + photon
    identity = b"scene=a.yaml\nrender.photons=1\nno value\n\n"
    yield struct.pack("<8sQ3Q", b"hyaphot2", len(identity), 1, 0, 0) + identity + photon
    yield struct.pack("<8sQ3Q", b"hyaphot1", 0, 1, 0, 0) + photon


def main():
    folder = pathlib.Path(sys.argv[1])
    for name, seeds in {"scene": scene_seeds, "obj": obj_seeds, "ply": ply_seeds, "stl": stl_seeds, "gltf": gltf_seeds,
                        "image": image_seeds, "checkpoint": checkpoint_seeds, "photons": photons_seeds}.items():
        (folder / name).mkdir(parents=True, exist_ok=True)
        for number, seed in enumerate(seeds()):
            (folder / name / f"seed-{number}").write_bytes(seed)


main()
