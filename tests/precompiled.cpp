// Holds nothing: its precompiled headers are those of the test programs.
