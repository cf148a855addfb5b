"""Why is a goal not met? What was measured of the reason, by the goal's number."""

REASONS: dict[str, str] = {}
