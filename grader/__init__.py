"""bvhgrade: grades one C++ file that builds and traverses a bounding volume hierarchy."""

__version__ = "0.1.0"
