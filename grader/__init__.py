"""bvhgrade: grades one C++ file that builds and traverses a bounding volume hierarchy."""

import os

__version__ = "0.1.0"

# Matrices are small here, but numpy's library for them starts a thread for each processor when
# it is loaded, which is a third of what loading numpy costs.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
