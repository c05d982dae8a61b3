// Holds nothing: its precompiled headers are those of other targets.
