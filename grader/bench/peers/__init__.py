"""Programs that time another ray tracer, each in a process of its own; none is imported."""
