"""Who handed in whose code? Fingerprints of what students wrote, compared pair by pair.

The fingerprints are those of copydetect, an optional extra; it runs in a confined process,
because it reads what strangers wrote.
"""
