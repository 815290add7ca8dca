"""What accuracy costs: cases, options and programs to compare with, of
tests/benchmark/trade/trade.py."""
