//! The attribute `multiversion` for a device, which has one version of every function.

extern crate proc_macro;

use proc_macro::TokenStream;

#[proc_macro_attribute]
pub fn multiversion(_: TokenStream, function: TokenStream) -> TokenStream {
    let mut all: TokenStream = "#[inline(always)]".parse().unwrap();
    all.extend(function);
    all
}
