//! How much memory is free: the only file that asks the machine.

/// Memory that may be taken without swapping [bytes]; none without the feature `memory`, where nothing knows.
pub fn available() -> Option<u64> {
    #[cfg(feature = "memory")]
    {
        let mut system = sysinfo::System::new();
        system.refresh_memory();
        Some(system.available_memory())
    }
    #[cfg(not(feature = "memory"))]
    None
}

#[cfg(test)]
mod tests {
    #[test]
    fn some_is_free() {
        assert!(super::available().is_some_and(|free| free > 1_000_000));
    }
}
