#![doc = include_str!("../README.md")]

mod answer;
mod areas;
mod defects;
mod inspect;
mod message;
mod numbers;
mod pace;
mod page;
mod place;
mod plan;
mod request;
mod run;
mod start;
mod surface;
mod trouble;

pub use answer::answer;
pub use message::Messages;
pub use page::{page, page_of_program};
pub use place::Host;
