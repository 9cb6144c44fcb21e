"""Kills renders at random moments (SIGKILL) and checks the files they leave: PROGRAM COUNT [SEED [cold]].

Each render resumes from the checkpoint of the previous one. After every kill the checkpoint must be intact or not exist
yet, never hold fewer passes than before, and an existing picture must be complete. A render that finishes must produce the
bytes of an uninterrupted one; then the next starts from scratch: `cold` gives it empty caches. On failure the folder with
scene, pictures, checkpoint and caches is kept, and its path printed.
"""

import json
import os
import pathlib
import random
import shutil
import subprocess
import sys
import tempfile
import time

SCENE = """hyalite: 1
camera: {position: [0, 0, 4], resolution: [48, 48]}
render: {passes: 300, photons: 2000, caustic_photons: 0}
materials: {gray: {type: diffuse}}
lights: [{type: point, position: [0, 1, 2]}]
objects: [{shape: {type: sphere, radius: 1}, material: gray}]
"""
WHOLE = ["render", "scene.yaml", "--quiet"]
KEPT = ["--checkpoint", "kept", "--resume", "--checkpoint-every", "0", "-o", "picture.exr"]


def run(program, folder, arguments, environment):
    return subprocess.run([program, *arguments], cwd=folder, env=environment, capture_output=True, text=True, check=False,
                          timeout=600)


def passes_kept(program, folder, environment):
    """Number of passes in the checkpoint; 0: it does not exist."""
    if not (folder / "kept").exists():
        return 0
    result = run(program, folder, ["merge", "kept", "-o", "merged.exr", "--json"], environment)
    if result.returncode != 0:
        raise AssertionError(f"a kill has damaged the checkpoint: {result.stderr}")
    return json.loads(result.stdout)["passes"]


def check_end(program, folder, exit_code, environment):
    """Raises AssertionError unless a render succeeded with the bytes of the uninterrupted one; says which condition failed."""
    if exit_code != 0:
        raise AssertionError(f"exit code {exit_code}")
    picture, whole = ((folder / name).read_bytes() for name in ("picture.exr", "whole.exr"))
    if picture == whole:
        return
    run(program, folder, [*WHOLE, "-o", "again.exr"], environment)
    again = (folder / "again.exr").read_bytes()
    odd = "the killed one is odd" if again == whole else "the whole one is odd" if again == picture else "all are odd"
    raise AssertionError(f"a render that was killed has other bytes than one that was not; rendered again, {odd}")


def kill_renders(program, count, seed=1, environment=None, cold=False):
    """Returns the number of kills that hit a running render, the number of renders that finished, and leftovers."""
    environment = dict(os.environ if environment is None else environment)
    choose = random.Random(seed)
    kills = ends = 0
    folder = pathlib.Path(tempfile.mkdtemp(prefix="hyalite-kills-"))

    def cool():
        environment.update({"XDG_CACHE_HOME": str(folder / f"cache-{ends}")} if cold else {})

    try:
        (folder / "scene.yaml").write_text(SCENE)
        cool()
        begin = time.monotonic()
        result = run(program, folder, [*WHOLE, "-o", "whole.exr"], environment)
        if result.returncode != 0:
            raise AssertionError(result.stderr)
        whole = (folder / "whole.exr").read_bytes()
        longest = 0.8 * (time.monotonic() - begin)
        before = 0
        while kills < count:
            process = subprocess.Popen([program, *WHOLE, *KEPT], cwd=folder, env=environment, stderr=subprocess.PIPE)
            try:
                process.communicate(timeout=choose.uniform(0, longest))
            except subprocess.TimeoutExpired:
                process.kill()
                process.communicate()
                kills += 1
                passes = passes_kept(program, folder, environment)
                if passes < before:
                    raise AssertionError(f"{before} passes were kept, and after a kill {passes}")
                before = passes
                if (folder / "picture.exr").exists() and (folder / "picture.exr").read_bytes() != whole:
                    raise AssertionError("a kill has left half a picture")
                continue
            check_end(program, folder, process.returncode, environment)
            ends += 1
            before = 0
            (folder / "kept").unlink()
            (folder / "picture.exr").unlink()
            cool()
        leftovers = len(list(folder.glob(".hyalite-*.tmp")))
    except AssertionError as error:
        raise AssertionError(f"{error}; see {folder}") from error
    shutil.rmtree(folder)
    return kills, ends, leftovers


if __name__ == "__main__":
    hit, ended, left = kill_renders(str(pathlib.Path(sys.argv[1]).resolve()), int(sys.argv[2]),
                                    int(sys.argv[3]) if len(sys.argv) > 3 else 1, cold=sys.argv[4:5] == ["cold"])
    print(f"{hit} kills: every checkpoint and picture whole; {ended} renders came to their end with the right bytes; "
          f"{left} temporary files left behind")
