//! The order of the built-in theories in tables and figures.

use super::{
    archard, bgt, chang_etsion_bogy, equation, greenwood_elliptical, gw, majumdar_bhushan,
    multiscale, persson, persson_yield, stacked,
};
use crate::theory::Theory;
use std::sync::Arc;

/// Every built-in theory.
pub(crate) fn all() -> Vec<Arc<dyn Theory>> {
    let rows = [
        gw::theory(),
        bgt::theory(),
        greenwood_elliptical::theory(),
        persson::theory(),
        stacked::theory(),
        multiscale::theory(),
        archard::theory(),
        majumdar_bhushan::theory(),
        equation::theory(),
        chang_etsion_bogy::theory(),
        persson_yield::theory(),
    ];
    rows.into_iter().map(super::row::Row::theory).collect()
}
