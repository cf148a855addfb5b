"""The demo application: a submission's tree and rays, looked at from any side."""
