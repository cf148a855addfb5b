"""Other people's formats, one module a host: each makes texts of `result.json`."""
