#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| boundfit_tests::fuzz_targets::packed_reader(data));
