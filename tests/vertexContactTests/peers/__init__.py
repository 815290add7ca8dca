"""Our cases for programs from packages (tests/benchmark/peers)."""
