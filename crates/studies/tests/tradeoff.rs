//! The example `tradeoff` from measurement to page; its tests stand beside what they test.

#![allow(dead_code, reason = "the example uses all of it")]

#[path = "../examples/tradeoff/measure.rs"]
mod measure;
#[path = "../examples/tradeoff/page.rs"]
mod page;
