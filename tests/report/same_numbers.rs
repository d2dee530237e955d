//! same_numbers
