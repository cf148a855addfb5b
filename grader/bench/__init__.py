"""How fast is the grader? Ratios, each measured inside one run, and what they cost by size."""
