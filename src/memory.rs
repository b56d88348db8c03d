//! How much memory is free: the only file that asks the machine.

/// Memory that may be taken without swapping [bytes].
pub fn available() -> u64 {
    let mut system = sysinfo::System::new();
    system.refresh_memory();
    system.available_memory()
}

#[cfg(test)]
mod tests {
    #[test]
    fn some_is_free() {
        assert!(super::available() > 1_000_000);
    }
}
