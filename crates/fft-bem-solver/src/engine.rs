//! From a surface and a load in SI units to a solution, through the scaled problem.

use crate::methods::{
    self, Compliance, ContactMethod, ContactTask, IterateView, Means, Outcome, Start, State, Target,
};
use crate::observer::Observe;
use crate::problem::Problem;
use crate::{
    Boundary, End, HalfSpace, Iteration, Load, Method, Real, Solution, SolverBuilder, SolverError,
    control, fields, special_cases,
};
use contact_types::{Clock, ContactModulus, Grid, HeightMap};
use std::sync::Arc;

/// Everything a solve needs, in the floating-point type of the solve.
pub(crate) struct Engine<T: Real> {
    pub(crate) settings: SolverBuilder,
    modulus: ContactModulus,
    scaled: Grid,
    method: Box<dyn ContactMethod<T>>,
    pub(crate) operator: HalfSpace<T>,
    pub(crate) state: State<T>,
    problem: Option<Arc<Problem<T>>>,
    /// Mean pressure that closes every gap of the problem, once it is known.
    closing_load: Option<f64>,
    /// Mean pressure below which the method does not expect that, once it was asked.
    suspected_closing_load: Option<f64>,
    is_warm: bool,
    /// Whether the state is warm by its pressure alone: its displacement is not that of it.
    lacks_displacement: bool,
}

/// Pressure (Pa) of each pixel, by its index, that a solve begins at.
pub(crate) type StartPressure<'a> = dyn Fn(usize) -> f64 + Sync + 'a;

/// An engine, whatever the type it computes in.
pub(crate) trait AnyEngine: Send + Sync {
    fn forget(&mut self);

    /// Makes `surface` the one to be solved.
    fn keep(&mut self, surface: &HeightMap) -> Result<(), SolverError>;

    fn begin_at(&mut self, pressure: &StartPressure<'_>) -> Result<(), SolverError>;

    fn solve(
        &mut self,
        load: Load,
        observer: &mut Observe<'_>,
        clock: Clock,
    ) -> Result<Solution, SolverError>;
}

impl<T: Real> Engine<T> {
    pub(crate) fn new(
        settings: SolverBuilder,
        modulus: ContactModulus,
        scaled: Grid,
    ) -> Result<Self, SolverError> {
        let method = methods::build(settings.method, scaled, settings.boundary)?;
        let operator = HalfSpace::scaled(scaled, settings.boundary);
        Ok(Self {
            settings,
            modulus,
            scaled,
            method,
            operator,
            state: State::new(scaled.len()),
            problem: None,
            closing_load: None,
            suspected_closing_load: None,
            is_warm: false,
            lacks_displacement: false,
        })
    }
}

impl<T: Real> AnyEngine for Engine<T> {
    fn forget(&mut self) {
        self.is_warm = false;
    }

    fn keep(&mut self, surface: &HeightMap) -> Result<(), SolverError> {
        if self.problem.as_ref().is_some_and(|known| known.is_of(surface)) {
            return Ok(());
        }
        self.is_warm = false;
        self.closing_load = None;
        self.suspected_closing_load = None;
        self.problem = None;
        self.problem = Some(Arc::new(Problem::new(surface, self.scaled, self.modulus)?));
        Ok(())
    }

    fn begin_at(&mut self, pressure: &StartPressure<'_>) -> Result<(), SolverError> {
        let unit = self.problem.as_ref().ok_or(SolverError::NoSurface)?.units.pressure;
        let own = &mut self.state.pressure;
        fields::write(own, |i, _| T::of(pressure(i).max(0.0) / unit));
        let sum = fields::sum(own);
        self.is_warm = sum > 0.0 && sum.is_finite();
        self.lacks_displacement = self.is_warm;
        Ok(())
    }

    fn solve(
        &mut self,
        load: Load,
        observer: &mut Observe<'_>,
        clock: Clock,
    ) -> Result<Solution, SolverError> {
        let problem = &*self.problem.clone().ok_or(SolverError::NoSurface)?;
        let ceiling = self.ceiling(problem);
        let prescribed = self.prescribed(problem, load, ceiling)?;
        let start = if self.is_warm { Start::Warm } else { Start::Cold };
        self.is_warm = false; // until this solve has left a useful state behind
        let found = match prescribed {
            LoadMeaning::Apart(level) => self.apart(level),
            LoadMeaning::Closed => self.closed(problem),
            LoadMeaning::Yielded => self.yielded(problem, ceiling),
            LoadMeaning::Target(target) => {
                let is_chord = self.settings.method == Method::Chord;
                let task = ContactTask {
                    problem,
                    target,
                    start,
                    ceiling,
                    tolerance: self.settings.tolerance,
                    max_iterations: if is_chord { 200 } else { 20_000 },
                    ends_on_trial: self.settings.ends_on_trial && is_chord,
                };
                self.target(task, observer)
            }
        };
        let solution = self.solution(problem, &found, load, clock);
        self.is_warm = solution.diagnostics.contact_pixels > 0;
        match found.end {
            End::Converged => Ok(solution),
            End::Rounding => Err(SolverError::Rounding(Box::new(solution))),
            End::Exhausted => Err(SolverError::NotConverged(Box::new(solution))),
            End::Stopped => Err(SolverError::Stopped(Box::new(solution))),
        }
    }
}

impl<T: Real> Engine<T> {
    /// The highest pressure, in units of the problem.
    pub(crate) fn ceiling(&self, problem: &Problem<T>) -> f64 {
        self.settings.hardness / problem.units.pressure
    }

    /// Checks the load and says what it means for this problem.
    fn prescribed(
        &self,
        problem: &Problem<T>,
        load: Load,
        ceiling: f64,
    ) -> Result<LoadMeaning, SolverError> {
        let (quantity, value, unit) = match load {
            Load::MeanPressure(p) => ("mean pressure", p, "Pa"),
            Load::MeanGap(g) => ("mean gap", g, "m"),
        };
        let bad = |limit| Err(SolverError::BadLoad { quantity, value, unit, limit });
        if !value.is_finite() || value < 0.0 {
            return bad("it must be a finite number, not negative");
        }
        let most = -problem.mean_height; // the level at which every gap is closed
        let (hardness, yields) = (self.settings.hardness, ceiling.is_finite());
        match load {
            Load::MeanPressure(pressure) if pressure > hardness => {
                Err(SolverError::AboveHardness { mean_pressure: pressure, hardness })
            }
            Load::MeanPressure(pressure) if pressure >= hardness => Ok(LoadMeaning::Yielded),
            Load::MeanPressure(pressure) => {
                let scaled = pressure / problem.units.pressure;
                if pressure > 0.0 && !(1e-30..1e30).contains(&scaled) {
                    return Err(SolverError::Range {
                        quantity: "mean pressure over E* times the slope of the surface",
                        value: scaled,
                        way_out: "such a load is no contact or plain compression: \
                                  leave it out or scale it",
                    });
                }
                Ok(match scaled {
                    s if s > 0.0 => LoadMeaning::Target(Target::Pressure(s)),
                    _ => LoadMeaning::Apart(0.0),
                })
            }
            Load::MeanGap(_) if self.settings.boundary != Boundary::Periodic => {
                Err(SolverError::Combination {
                    first: "control by mean gap",
                    second: "the free boundary",
                    way_out: "prescribe the mean pressure",
                })
            }
            Load::MeanGap(gap) if gap <= 0.0 && yields => {
                bad("with a hardness no least load that closes every gap is looked for; \
                     prescribe a wider gap or the mean pressure")
            }
            Load::MeanGap(gap) if gap <= 0.0 => Ok(LoadMeaning::Closed),
            Load::MeanGap(gap) => {
                let gap = gap / problem.units.height;
                let level = most - gap;
                if level <= 0.0 {
                    Ok(LoadMeaning::Apart(level))
                } else if level >= most && !yields {
                    bad("it would take the flat deeper than where every gap is closed; \
                         prescribe the mean pressure instead")
                } else {
                    let guess = first_guess(problem, level.min(0.999 * most));
                    Ok(LoadMeaning::Target(Target::Gap(gap, guess)))
                }
            }
        }
    }

    /// Nothing carries load: the undeformed surface, its highest point at `-level` from the flat.
    fn apart(&mut self, level: f64) -> Outcome {
        self.state.pressure.fill(T::zero());
        self.state.displacement.fill(T::zero());
        self.state.level = level;
        Outcome::exact("no load", 0.0)
    }

    /// The least load that closes every gap.
    fn closed(&mut self, problem: &Problem<T>) -> Outcome {
        let (operator, state) = (&mut self.operator, &mut self.state);
        let least = special_cases::flattening_pressure(problem, operator, &mut state.pressure);
        special_cases::full_contact(problem, least.unwrap_or(0.0), state);
        Outcome::exact("full contact", 1.0)
    }

    /// Everything at the ceiling. The flat is where the lowest point still touches it.
    fn yielded(&mut self, problem: &Problem<T>, ceiling: f64) -> Outcome {
        let spent = self.state.fill(ceiling, &mut self.operator);
        let u = &self.state.displacement;
        let rise = |i: usize| (u[i] - problem.heights[i]).wide();
        self.state.level = fields::largest_of(u.len(), rise);
        Outcome::exact("all of the surface yields", spent)
    }

    fn target(&mut self, mut task: ContactTask<'_, T>, observer: &mut Observe<'_>) -> Outcome {
        let mut spent = 0.0;
        let lacks_displacement = std::mem::take(&mut self.lacks_displacement);
        if let Target::Pressure(load) = task.target {
            match self.without_iterating(&mut task, load) {
                (Some(reason), transforms) => return Outcome::exact(reason, transforms),
                (None, transforms) => spent += transforms,
            }
        }
        if task.start == Start::Warm && lacks_displacement {
            self.operator.apply(&self.state.pressure, &mut self.state.displacement);
            spent += 1.0;
        }
        let n = task.problem.heights.len() as f64;
        let mut watch = |step: &IterateView<'_, T>| {
            observer(&Iteration {
                number: step.iteration,
                transforms: spent + step.transforms,
                residual: step.residual,
                tolerance: task.tolerance,
                area: &|| fields::contact_count(&step.state.pressure) as f64 / n,
            })
        };
        let (operator, state) = (&mut self.operator, &mut self.state);
        let means = Means { operator, state, watch: &mut watch };
        let mut outcome = control::solve(self.method.as_mut(), task, means);
        outcome.transforms += spent;
        self.lacks_displacement = task.ends_on_trial;
        if outcome.end == End::Exhausted && outcome.residual <= T::ATTAINABLE {
            outcome.end = End::Rounding;
        }
        outcome
    }

    /// Tries the answers that need no iteration. Returns which it was, and the convolutions spent.
    fn without_iterating(
        &mut self,
        task: &mut ContactTask<'_, T>,
        load: f64,
    ) -> (Option<&'static str>, f64) {
        let (problem, mut spent) = (task.problem, 0.0);
        let (operator, state) = (&mut self.operator, &mut self.state);
        let total = load * problem.heights.len() as f64;
        let ceiling = T::of(task.ceiling).wide();
        let summit = special_cases::lonely_summit(problem, load);
        if let Some(summit) = summit.filter(|_| total <= ceiling) {
            spent += 1.0;
            if special_cases::single_pixel(problem, summit, load, operator, state) {
                return (Some("single pixel in contact"), spent);
            }
            task.start = Start::Cold;
        }
        if self.settings.boundary != Boundary::Periodic {
            return (None, spent);
        }
        if problem.is_flat() {
            state.pressure.fill(T::of(load));
            state.displacement.fill(T::zero());
            state.level = 0.0;
            return (Some("flat surface"), spent);
        }
        if self.closing_load.is_some_and(|least| load < least) {
            return (None, spent);
        }
        let suspected = self.suspected_closing_load.unwrap_or_else(|| {
            let (suspected, cost) = self.method.suspected_closing_load(problem);
            spent += cost;
            suspected
        });
        self.suspected_closing_load = Some(suspected);
        if load >= suspected {
            // A warm state is still needed if this fails.
            let mut field = match task.start {
                Start::Cold => std::mem::take(&mut state.pressure),
                Start::Warm => Vec::new(),
            };
            spent += 1.0;
            self.closing_load = special_cases::flattening_pressure(problem, operator, &mut field);
            let closes = self.closing_load.is_some_and(|least| load >= least)
                && (ceiling.is_infinite() || fields::max(&field) + load <= ceiling);
            if closes || task.start == Start::Cold {
                state.pressure = field;
            }
            if closes {
                special_cases::full_contact(problem, load, state);
                return (Some("full contact"), spent);
            }
        }
        (None, spent)
    }
}

enum LoadMeaning {
    /// No contact; level of the flat.
    Apart(f64),
    /// Every gap just closed.
    Closed,
    /// Everything at the ceiling.
    Yielded,
    Target(Target),
}

/// A rough mean pressure for a level: slope times the fraction of the surface above the flat.
fn first_guess<T: Real>(problem: &Problem<T>, level: f64) -> f64 {
    let [ny, nx] = problem.grid.shape();
    let [dy, dx] = problem.grid.pixel();
    let h = |iy: usize, ix: usize| problem.heights[(iy % ny) * nx + ix % nx].wide();
    let slope2 = fields::sum_of(ny * nx, |i| {
        let (iy, ix) = (i / nx, i % nx);
        ((h(iy + 1, ix) - h(iy, ix)) / dy).powi(2) + ((h(iy, ix + 1) - h(iy, ix)) / dx).powi(2)
    }) / (ny * nx) as f64;
    let above = problem.heights.iter().filter(|h| h.wide() > -level).count().max(1);
    0.25 * slope2.sqrt() * above as f64 / (ny * nx) as f64
}
