"""Work that is cut into jobs, done anywhere, and put together again (docs/cluster.md).

parcels.py: folders as bytes. jobs.py: what is to be done, as values that travel, and how it is done in one process, by the functions
that everybody calls. crew.py: Ray's part, who does which job. marketgen.ray is what users call.
"""
