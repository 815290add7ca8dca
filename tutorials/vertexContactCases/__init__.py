"""What tutorials and cases of users share: to read results, to draw them, and
the theories that they are compared with. etc/bashrc puts it on PYTHONPATH."""
