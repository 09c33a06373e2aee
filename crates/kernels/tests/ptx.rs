//! The kernels for a device take what the host hands over: entry points and the sizes of their parameters.

use kernels::launch::Kernel;
use kernels::{PTX_DOUBLE, PTX_SINGLE, double, single};

/// Sizes of the parameters of an entry point [bytes], from the text.
fn parameters(text: &str, name: &str) -> Vec<usize> {
    let start = text.find(&format!(".entry {name}(")).unwrap_or_else(|| panic!("no {name}"));
    let list = text[start..].split(')').next().unwrap_or_default();
    let size = |line: &str| match line.split_once('[') {
        Some((_, size)) => size.split(']').next()?.parse().ok(),
        None => line.contains(".u64").then_some(8),
    };
    list.lines().filter(|line| line.contains(".param")).filter_map(size).collect()
}

#[test]
fn entry_points_take_what_is_handed_over() {
    for kernel in Kernel::ALL {
        let name = kernel.name();
        let sizes = [size_of::<double::device_arrays::Arrays>(), double::device_run::size_of_more(*kernel)];
        assert_eq!(parameters(PTX_DOUBLE, name), sizes, "{name}, double precision");
        let sizes = [size_of::<single::device_arrays::Arrays>(), single::device_run::size_of_more(*kernel)];
        assert_eq!(parameters(PTX_SINGLE, name), sizes, "{name}, single precision");
    }
    assert_eq!(PTX_DOUBLE.matches(".entry").count(), Kernel::ALL.len());
}
