"""Watches the memory of a long render: PROGRAM SCENE SECONDS. Fails if it grows after the first minute.

A shorter run counts from its first quarter on. Resident memory is sampled every half second; the median of the last tenth
of the samples may exceed that of the first tenth by 1 % plus 1 MiB. Some samples fall into the writing of a checkpoint,
which copies the film for a moment: that is not growth.
"""

import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import time


def resident(process):
    """[KiB]; None: the process has ended."""
    try:
        found = re.search(r"VmRSS:\s+(\d+) kB", pathlib.Path(f"/proc/{process.pid}/status").read_text())
    except FileNotFoundError:
        return None
    return int(found[1]) if found else None


def watch(program, scene, seconds):
    """Resident memory [KiB] and the times of the samples [s]."""
    seen = []
    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen([program, "render", scene, "--quiet", "--resolution", "128x128", "--passes", "100000000",
                                    "--time", str(seconds), "--checkpoint", "kept", "--checkpoint-every", "20"],
                                   cwd=folder)
        begin = time.monotonic()
        while process.poll() is None:
            size = resident(process)
            if size is not None:
                seen.append((time.monotonic() - begin, size))
            time.sleep(0.5)
        if process.returncode != 0:
            sys.exit(f"leak.py: hyalite ended with exit code {process.returncode}")
    return [(when, size) for when, size in seen if when < seconds]  # after that pictures are made


def main():
    program, scene = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
    seconds = float(sys.argv[3])
    seen = watch(program, scene, seconds)
    start = min(60.0, seconds / 4)
    counted = [size for when, size in seen if when >= start]
    tenth = max(1, len(counted) // 10)
    first, last = statistics.median(counted[:tenth]), statistics.median(counted[-tenth:])
    print(f"{seconds:.0f} s: {first / 1024:.1f} MiB resident after {start:.0f} s, {last / 1024:.1f} MiB at the end, "
          f"{max(counted) / 1024:.1f} MiB at most")
    if last > 1.01 * first + 1024:
        sys.exit("leak.py: it grows")


if __name__ == "__main__":
    main()
