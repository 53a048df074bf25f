#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| boundfit_tests::fuzz_targets::slow_units(data));
