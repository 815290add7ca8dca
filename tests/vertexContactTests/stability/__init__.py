"""The stability map: scenes that go to an extreme, and how a run of one is
judged."""
