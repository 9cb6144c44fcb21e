"""Shared by the measuring scripts: imports numpy and matplotlib, or tells how to install them, and makes plots
reproducible: the same figures give the same file."""

import sys

try:
    import matplotlib
    import numpy
except ImportError as missing:
    sys.exit(f"{missing}: install Debian's package (apt-get install python3-matplotlib) and run this with Debian's own "
             "/usr/bin/python3")
matplotlib.use("svg")
matplotlib.rcParams["svg.hashsalt"] = "hyalite"
from matplotlib import pyplot  # noqa: E402  (the backend is chosen first)

__all__ = ["numpy", "pyplot"]
