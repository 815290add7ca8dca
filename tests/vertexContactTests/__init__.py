"""Code that tests and benchmarks share. etc/bashrc puts it on PYTHONPATH."""
