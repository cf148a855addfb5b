"""How one C++ file becomes a library, or readable compiler messages."""
