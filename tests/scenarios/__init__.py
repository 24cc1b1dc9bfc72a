"""What programs do on a CLICK, written by hand from the references: tables of scans for a simulator to run."""
