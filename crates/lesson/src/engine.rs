//! The engine inside the page: the WebAssembly module of `wasm`, and the script that a Worker runs it with.
//!
//! The folder `engine` has both, so that this crate can be packaged; `wasm/build.sh` writes the module there.

#[cfg(feature = "engine")]
pub(crate) use with_engine::{POLICY, elements};
#[cfg(not(feature = "engine"))]
pub(crate) use without_engine::{POLICY, elements};

#[cfg(feature = "engine")]
mod with_engine {
    use base64::Engine;
    use base64::engine::general_purpose::STANDARD;

    /// Further permissions of the page: compile WebAssembly, and start Workers from a script of its own.
    pub(crate) const POLICY: &str = " 'wasm-unsafe-eval'; worker-src blob:";

    /// The module that answers the page's own questions and the fit alone, packed by gzip.
    const MODULE: &[u8] = include_bytes!("../engine/page.wasm.gz");
    /// The code that wasm-bindgen writes to go with the module.
    const BINDINGS: &str = include_str!("../engine/boundfit_wasm.mjs");
    /// The Worker's code for both; its imports are the code before it in one script.
    const WORKER: &str = include_str!("../engine/worker.mjs");

    /// The elements with the module and the script of the Worker, which the page does not run itself.
    pub(crate) fn elements() -> String {
        format!(
            "<script type=\"application/octet-stream;base64\" id=\"engine-module\">{}</script>\n\
             <script type=\"text/plain\" id=\"engine-worker\">\n{}\n</script>\n",
            STANDARD.encode(MODULE),
            script()
        )
    }

    /// Both scripts as one that is no module: browsers start no Worker from a module of a page that is a file.
    fn script() -> String {
        let lines = BINDINGS.lines().chain(WORKER.lines());
        let joined = lines.filter(|line| !line.starts_with("import ") && !line.starts_with("export {"));
        joined.map(|line| line.strip_prefix("export ").unwrap_or(line)).collect::<Vec<_>>().join("\n")
    }

    #[cfg(test)]
    mod tests {
        use super::*;

        #[test]
        fn nothing_of_the_engine_ends_the_element_that_it_is_in() {
            for source in [BINDINGS, WORKER] {
                assert!(!source.contains("</script") && !source.contains("<!--"));
            }
            assert_eq!(elements().matches("</script>").count(), 2);
        }

        #[test]
        fn the_script_of_the_worker_is_no_module() {
            assert!(!script().lines().any(|line| line.starts_with("import ") || line.starts_with("export ")));
            assert!(!script().contains("import.meta"));
        }
    }
}

#[cfg(not(feature = "engine"))]
mod without_engine {
    /// The page computes nothing beyond its script.
    pub(crate) const POLICY: &str = "";

    /// Returns nothing: this build has no engine.
    pub(crate) fn elements() -> String {
        String::new()
    }
}
