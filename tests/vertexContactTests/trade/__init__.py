"""The cost of accuracy: cases, options and compared programs of
tests/benchmark/trade/trade.py."""
