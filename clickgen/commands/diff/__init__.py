"""The work of ``clickgen diff``: two programs, bundles or revisions, rung by rung, in the words of the listing."""
