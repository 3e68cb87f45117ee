//! On macOS a module finds Python's symbols in the program that loads it: the linker is told so, whoever builds it.

fn main() {
    pyo3_build_config::add_extension_module_link_args();
}
