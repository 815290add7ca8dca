#!/usr/bin/env python3
"""Draw the deformed bodies of a case: -h prints the options."""

from vertexContactCases.renderCase import main

if __name__ == "__main__":
    main()
