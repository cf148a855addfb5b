"""What lies in memory that a submission wrote is read as numbers that nobody stumbles over."""

import numpy as np

from grader.run.transfer import hits_of


def test_a_signalling_number_is_quiet_once_it_is_read() -> None:
    """Numpy would warn of each calculation with it, on the terminal of whoever grades."""
    table = np.full((2, 7), 0x7FA00000, np.uint32).view(np.float32)
    table[1] = (1, -0.0, 1e-45, np.inf, -np.inf, 3e38, np.nan)
    hits = hits_of(table)
    for part in (hits.point, hits.t, hits.normal):
        part.astype(np.float64)
    read = np.column_stack([hits.point, hits.t, hits.normal])
    assert np.isnan(read[0]).all()
    assert read[1].tobytes() == table[1].tobytes()
