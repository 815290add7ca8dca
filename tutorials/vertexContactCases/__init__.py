"""Code that tutorials and users' cases share: reading results, drawing them,
and theories to compare with. etc/bashrc puts it on PYTHONPATH."""
