"""Options of scripts: -h prints what the head of the script says."""

import argparse


def parser(doc):
    """A parser for a script with this docstring."""
    return argparse.ArgumentParser(
        description=doc, formatter_class=argparse.RawDescriptionHelpFormatter)
