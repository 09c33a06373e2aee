//! A simulation that another program steps and steers: from one exchange to the next that says how bodies
//! move, and gets what the soil has done to them.

use super::{Observer, ObserverError, Simulation, Stop, asked};
use case::resolved::Joint;
use glam::{DQuat, DVec3};
use mechanics::{Mobility, Pose, Steering, Twist, Wrench};
use results::fields::surface_heights;
use solver::error::Breakdown;
use solver::precision::Precision;
use solver::state::ContactImpulse;

/// How a body moves until the next exchange. Vectors are along the axes of space, moments about the body's
/// reference point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Command {
    /// As the case says.
    Own,
    /// As the case says, under a further constant load [N, N m].
    Load(Wrench),
    /// At a constant twist.
    Twist(Twist),
    /// At the constant twist that carries it to a pose. Of rotation the shorter way is taken.
    Pose(Pose),
    /// As a body of the other program's mechanism.
    Coupled(Coupled),
}

/// A body of a mechanism that another program moves, as it stands at an exchange. Soil and mechanism are
/// solved together: the body yields to the soil as `mobility` says, so that the exchange is stable however
/// light it is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coupled {
    /// Where the body is.
    pub pose: Pose,
    /// Its twist.
    pub twist: Twist,
    /// Its mobility in the mechanism: J M⁻¹ Jᵀ of the Jacobian J of its reference point.
    pub mobility: Mobility,
    /// Change of its twist without the soil [m/s², rad/s²].
    pub acceleration: Twist,
}

/// What has become of a body between two exchanges.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reaction {
    /// Mean force and moment of the soil on the whole body [N, N m]. Its impulse is that of the soil.
    pub soil: Wrench,
    /// Where the body is now.
    pub pose: Pose,
    /// Its twist in the last step.
    pub twist: Twist,
    /// Sinkage below the undisturbed surface [m].
    pub sinkage: f64,
    /// Work of the soil on the whole body [J].
    pub work: f64,
}

/// Why an exchange did not come about.
#[derive(Debug, thiserror::Error)]
pub enum ExchangeError {
    /// The request cannot be fulfilled; the simulation stands as before.
    #[error("{0}")]
    Request(String),
    /// The physics has failed.
    #[error(transparent)]
    Breakdown(#[from] Breakdown),
}

/// A simulation as it stands at an exchange.
#[derive(Clone, Debug, PartialEq)]
pub struct Exchange {
    /// Time [s].
    pub time: f64,
    /// Longest step [s].
    pub time_step: f64,
    /// What has become of the bodies since the last exchange, in their order.
    pub reactions: Vec<Reaction>,
}

/// What a program that steers a simulation wants of it.
#[derive(Clone, Debug, PartialEq)]
pub enum Wish {
    /// To go on to a time [s] with these commands, by the number of the body.
    Until(f64, Vec<(usize, Command)>),
    /// To know the height of the ground at places (x, y) [m].
    Ground(Vec<[f64; 2]>),
    /// To get the state, to which it can be restored.
    Save,
    /// To go back to a state that was saved.
    Restore(Vec<u8>),
    /// To end the run here: its results are those of a finished one.
    Finish,
    /// To stop here; the run can be resumed.
    Stop,
}

/// A program that steers a simulation.
pub trait Steerer {
    /// The simulation stands at an exchange, and waits for the next wish.
    fn next(&mut self, exchange: Exchange) -> Wish;
    /// The last wish cannot be fulfilled; the next is asked for.
    fn refused(&mut self, why: String);
    /// The heights [m] that were wished for, as of [`Simulation::ground`].
    fn ground(&mut self, heights: Vec<Option<f64>>);
    /// The state that was wished for.
    fn saved(&mut self, state: Vec<u8>);
}

/// Difference from a whole number of steps, in steps, below which steps are not shortened.
const WHOLE: f64 = 1e-6;
/// Shortest time between two exchanges, in steps: the state cannot tell shorter times apart.
const SHORTEST: f64 = 1e-3;
/// Most steps between two exchanges, far from what a run can take.
const MOST_STEPS: f64 = 1e12;
/// Speed along a fixed degree of freedom, over that of the body, that counts as round-off.
const ROUND_OFF: f64 = 1e-6;
/// How far a coupled body may be from where it is in the other program, in cells.
const APART: f64 = 0.05;
/// Most that a body may turn in a step [rad].
const MOST_TURN: f64 = 0.5;

/// What goes on between two exchanges.
#[derive(Debug)]
pub(crate) struct ExchangeInterval {
    /// Steps to come.
    steps: Steps,
    began: f64,
    bodies: Vec<BodyInInterval>,
}

/// What a command asks of a body.
#[derive(Default)]
struct Asked {
    steering: Option<Steering>,
    /// Where it is put, and its twist there.
    at: Option<(Pose, Twist)>,
}

impl From<Steering> for Asked {
    fn from(steering: Steering) -> Self {
        Self { steering: Some(steering), at: None }
    }
}

/// Equal steps.
#[derive(Clone, Copy, Debug)]
struct Steps {
    number: u64,
    /// Length of each [s].
    dt: f64,
    /// The same over that of other steps.
    shortened: f64,
}

#[derive(Clone, Copy, Debug)]
struct BodyInInterval {
    impulse: ContactImpulse,
    /// Work of the soil [J].
    work: f64,
    /// Twist times time.
    moved: Twist,
    /// Twist at the start of a body that is coupled.
    coupled_at: Option<Twist>,
}

impl ExchangeInterval {
    pub(crate) fn is_over(&self) -> bool {
        self.steps.number == 0
    }
}

impl<R: Precision> Simulation<R> {
    /// Goes on to a time [s] of the next exchange with the program that steers the bodies; returns what has
    /// become of each, in their order. Bodies without a command move as the case says. Steps are shortened so
    /// that a whole number of them reaches the time, unless it does so anyway. Samples are taken on the way.
    ///
    /// # Errors
    /// [`ExchangeError`].
    ///
    /// # Examples
    /// A plate is pushed down at 10 mm/s until the soil carries 20 N:
    ///
    /// ```
    /// use coulter::simulation::{Command, Simulation};
    /// # use glam::DVec3;
    /// # use mechanics::Twist;
    /// # let text = include_str!("../../../../cases/strip_footing.toml");
    /// # let coarse = ["grid.cell=0.125 m".to_owned()];
    /// let case = coulter::case::parse(text, "case.toml", &coarse)?;
    /// let mut simulation = Simulation::<f64>::new(&case);
    /// let down = Twist { linear: DVec3::new(0.0, 0.0, -0.01), angular: DVec3::ZERO };
    /// loop {
    ///     let next = simulation.state.time + 0.01;
    ///     let footing = simulation.step_until(next, &[(0, Command::Twist(down))])?[0];
    ///     if footing.soil.force.z > 20.0 {
    ///         break;
    ///     }
    /// }
    /// # Ok::<(), Box<dyn std::error::Error + Send + Sync>>(())
    /// ```
    pub fn step_until(
        &mut self,
        time: f64,
        commands: &[(usize, Command)],
    ) -> Result<Vec<Reaction>, ExchangeError> {
        let mut interval = self.begin_interval(time, commands)?;
        while !interval.is_over() {
            self.step_in(&mut interval)?;
        }
        self.bring_home()?;
        Ok(self.end_interval(&interval))
    }

    /// Heights z [m] of the free surface at places (x, y) [m] as it is now: linear between the columns of
    /// cells. `None` outside the grid. Where a body is in the soil, the height is that of the soil under or
    /// over it: a sensor looks at the ground in front of a body or beside it. Soil moves up to a tenth of a
    /// cell before the grid knows of it.
    ///
    /// # Examples
    /// The furrows of a field, from crest to trough:
    ///
    /// ```
    /// # use coulter::simulation::Simulation;
    /// # let text = include_str!("../../../../cases/furrowed_field.toml");
    /// # let coarse = ["grid.cell=12 mm".to_owned()];
    /// let case = coulter::case::parse(text, "case.toml", &coarse)?;
    /// let simulation = Simulation::<f64>::new(&case);
    /// let heights = simulation.ground(&[[0.2, 0.2], [0.3, 0.2], [9.0, 0.2]]);
    /// assert!((heights[0].ok_or("outside")? - 0.01).abs() < 0.002);
    /// assert!((heights[1].ok_or("outside")? + 0.01).abs() < 0.002);
    /// assert_eq!(heights[2], None);
    /// # Ok::<(), Box<dyn std::error::Error + Send + Sync>>(())
    /// ```
    #[must_use]
    pub fn ground(&self, places: &[[f64; 2]]) -> Vec<Option<f64>> {
        surface_heights(&self.case, &self.model, self.halo(), &self.state, places)
    }

    /// Begins an interval; changes nothing where it is refused.
    pub(crate) fn begin_interval(
        &mut self,
        time: f64,
        commands: &[(usize, Command)],
    ) -> Result<ExchangeInterval, ExchangeError> {
        let steps = self.steps_to(time).map_err(ExchangeError::Request)?;
        let mut steering = vec![None; self.model.bodies.len()];
        let mut placed = Vec::new();
        for (body, command) in commands {
            let Some(own) = steering.get_mut(*body) else {
                return Err(ExchangeError::Request(format!("there is no body number {body}")));
            };
            let asked = self.asked(*body, command, steps);
            let Asked { steering: asked, at } = asked.map_err(|why| {
                ExchangeError::Request(format!("body {}: {why}", self.model.bodies[*body].name))
            })?;
            *own = asked;
            placed.extend(at.map(|(pose, twist)| (*body, pose, twist)));
        }
        let Self { model, state, workspace, history, .. } = self;
        history.exchange.steered.extend((0..steering.len()).filter(|n| steering[*n].is_some()));
        workspace.steer(model, state, &steering);
        for (body, pose, twist) in placed {
            let now = &mut state.mechanism.bodies[body];
            (now.pose, now.twist) = (pose, twist);
        }
        let is_coupled = |n: usize| matches!(steering[n], Some(Steering::Coupled { .. }));
        let bodies = state.bodies.iter().enumerate().map(|(n, body)| BodyInInterval {
            impulse: body.contact_impulse,
            work: 0.0,
            moved: Twist::ZERO,
            coupled_at: is_coupled(n).then(|| state.mechanism.bodies[n].twist),
        });
        Ok(ExchangeInterval { steps, began: state.time, bodies: bodies.collect() })
    }

    /// Takes a step of an interval, and a sample where one is due; returns whether one was.
    pub(crate) fn step_in(&mut self, interval: &mut ExchangeInterval) -> Result<bool, Breakdown> {
        let courant = self.model.method.courant;
        self.model.method.courant = interval.steps.shortened * courant;
        let dt = self.model.time_step();
        let stepped = self.step_and_sample();
        self.model.method.courant = courant;
        let is_sampled = stepped?;
        interval.steps.number -= 1;
        for (n, body) in interval.bodies.iter_mut().enumerate() {
            body.work += self.workspace.work(n).contact;
            body.moved += dt * *self.state.twist(n);
        }
        Ok(is_sampled)
    }

    /// What has become of the bodies in an interval. The work that another program works out from the mean
    /// force and its own motion is compared with that of the soil.
    pub(crate) fn end_interval(&mut self, interval: &ExchangeInterval) -> Vec<Reaction> {
        let lasted = self.state.time - interval.began;
        let mut reactions = Vec::with_capacity(interval.bodies.len());
        for (n, body) in interval.bodies.iter().enumerate() {
            let now = self.state.bodies[n].contact_impulse;
            let symmetry = self.model.symmetry();
            let normal = now.normal - body.impulse.normal;
            let friction = now.friction - body.impulse.friction;
            let impulse = Wrench {
                force: symmetry.of_whole(symmetry.of_whole(normal) + friction),
                moment: symmetry.moment_of_whole(now.moment - body.impulse.moment),
            };
            let soil = (1.0 / lasted) * impulse;
            if self.state.mechanism.bodies[n].is_elsewhere() {
                // A mass gains energy by its impulse times the mean of its velocities before and after.
                let moved = body.coupled_at.map(|before| 0.5 * lasted * (before + *self.state.twist(n)));
                let moved = moved.unwrap_or(body.moved);
                let exchange = &mut self.history.exchange;
                exchange.work += body.work.abs();
                exchange.difference += soil.dot(&moved) - body.work;
            }
            reactions.push((soil, body.work));
        }
        let standing = self.standing().into_iter().zip(reactions);
        standing.map(|(now, (soil, work))| Reaction { soil, work, ..now }).collect()
    }

    /// Runs the case as another program steers it, until that or an observer ends the run; observers as in
    /// [`Simulation::run`].
    ///
    /// # Errors
    /// That of the first observer that fails.
    pub fn run_steered(
        &mut self,
        observers: &mut [&mut dyn Observer<R>],
        steerer: &mut dyn Steerer,
    ) -> Result<Stop, ObserverError> {
        let mut reactions = self.standing();
        let stop = loop {
            if let Some(stop) = self.between_steps(observers)? {
                break stop;
            }
            let (time, time_step) = (self.state.time, self.model.time_step());
            let wish = steerer.next(Exchange { time, time_step, reactions: reactions.clone() });
            if matches!(wish, Wish::Ground(_) | Wish::Save)
                && let Err(cause) = self.bring_home()
            {
                break Stop::BrokenDown(cause);
            }
            match wish {
                Wish::Finish => break Stop::Finished,
                Wish::Stop => break Stop::Asked("the program that steers it".to_owned()),
                Wish::Ground(places) => steerer.ground(self.ground(&places)),
                Wish::Save => steerer.saved(self.checkpoint().to_bytes()?),
                Wish::Restore(state) => match self.restore(&state) {
                    Ok(()) => {
                        observers.iter_mut().try_for_each(|observer| observer.restored(self))?;
                        reactions = self.standing();
                    }
                    Err(why) => steerer.refused(why.to_string()),
                },
                Wish::Until(time, commands) => match self.begin_interval(time, &commands) {
                    Ok(mut interval) => {
                        if let Some(stop) = self.go_through(&mut interval, observers)? {
                            break stop;
                        }
                        reactions = self.end_interval(&interval);
                    }
                    Err(ExchangeError::Request(why)) => steerer.refused(why),
                    Err(ExchangeError::Breakdown(cause)) => break Stop::BrokenDown(cause),
                },
            }
        };
        self.end(stop, observers)
    }

    /// Takes the steps of an interval; how the run ended, if it did.
    fn go_through(
        &mut self,
        interval: &mut ExchangeInterval,
        observers: &mut [&mut dyn Observer<R>],
    ) -> Result<Option<Stop>, ObserverError> {
        while !interval.is_over() {
            let stop = match self.step_in(interval) {
                Err(cause) => return Ok(Some(Stop::BrokenDown(cause))),
                Ok(true) => asked(observers, |observer| observer.sampled(self))?,
                Ok(false) => None,
            };
            if stop.is_some() {
                return Ok(stop);
            }
        }
        Ok(None)
    }

    /// The bodies as they stand, without forces.
    fn standing(&self) -> Vec<Reaction> {
        let of = |n: usize| {
            let pose = *self.state.pose(n);
            let sinkage = self.model.surface - self.model.bodies[n].bounds(&pose).0.z;
            Reaction { soil: Wrench::ZERO, pose, twist: *self.state.twist(n), sinkage, work: 0.0 }
        };
        (0..self.model.bodies.len()).map(of).collect()
    }

    /// The steps to a time.
    fn steps_to(&self, time: f64) -> Result<Steps, String> {
        if !self.case.stages.is_empty() {
            return Err("a case with stages moves its bodies itself: leave out the stages".to_owned());
        }
        let (now, end, dt) = (self.state.time, self.case.duration, self.model.time_step());
        if !time.is_finite() || time - now < SHORTEST * dt {
            return Err(format!("the next exchange, at {time} s, is not after the present time of {now} s"));
        }
        if time > end + 0.5 * dt {
            return Err(format!("the case ends at {end} s, before {time} s: give it a longer run.duration"));
        }
        let exact = (time - now) / dt;
        let steps = (exact - WHOLE).ceil().max(1.0);
        if steps > MOST_STEPS {
            return Err(format!("{time} s is {steps:.0e} steps away"));
        }
        let shortened = if (exact - steps).abs() <= WHOLE { 1.0 } else { exact / steps };
        Ok(Steps { number: steps as u64, dt: shortened * dt, shortened })
    }

    /// What a command means for these steps, and where it puts the body.
    fn asked(&self, body: usize, command: &Command, steps: Steps) -> Result<Asked, String> {
        match command {
            Command::Own => Ok(Asked::default()),
            Command::Load(load) => {
                finite(&[load.force, load.moment])?;
                Ok(Steering::Loaded(*load).into())
            }
            Command::Twist(twist) => Ok(Steering::Prescribed(self.admitted(body, twist, steps.dt)?).into()),
            Command::Pose(pose) => {
                let twist = leading(self.state.pose(body), pose, steps)?;
                Ok(Steering::Prescribed(self.admitted(body, &twist, steps.dt)?).into())
            }
            Command::Coupled(coupled) => {
                self.alone(body)?;
                let twist = self.admitted(body, &coupled.twist, steps.dt)?;
                let at = self.near(body, &coupled.pose)?;
                finite(&[coupled.acceleration.linear, coupled.acceleration.angular])?;
                let fixed: Vec<Twist> = self.freedoms(body, true).map(|(_, column)| column).collect();
                let (mobility, acceleration) = coupled.mobility.held(&fixed, coupled.acceleration);
                Ok(Asked { at: Some((at, twist)), ..Steering::Coupled { mobility, acceleration }.into() })
            }
        }
    }

    /// A body of another program's mechanism has its joints there, and touches other bodies there.
    fn alone(&self, body: usize) -> Result<(), String> {
        let has = |joint: &&Joint| joint.first == Some(body) || joint.second == body;
        match self.case.joints.iter().find(has) {
            None => Ok(()),
            Some(joint) => Err(format!(
                "it has the joint `{}` here, whose forces the other program would not know: leave it out",
                joint.name
            )),
        }
    }

    /// The degrees of freedom of a body that the case fixes, or leaves: their numbers and unit twists.
    fn freedoms(&self, body: usize, fixed: bool) -> impl Iterator<Item = (usize, Twist)> {
        let units = self.state.mechanism.bodies[body].unit_twists();
        let motion = &self.model.bodies[body].motion;
        (0..6).filter(move |n| motion[*n].is_fixed() == fixed).map(move |n| (n, units[n]))
    }

    /// A twist that the fixed degrees of freedom admit, without what is round-off in them.
    fn admitted(&self, body: usize, twist: &Twist, dt: f64) -> Result<Twist, String> {
        finite(&[twist.linear, twist.angular])?;
        if twist.angular.length() * dt > MOST_TURN {
            return Err(format!(
                "it would turn by {:.2} rad in a step; {MOST_TURN} rad are admitted",
                twist.angular.length() * dt
            ));
        }
        let fixed = &self.model.bodies[body];
        let (low, high) = fixed.shape.bounds();
        let reach = low.abs().max(high).length();
        let speed = twist.linear.length() + reach * twist.angular.length();
        let rates = self.state.mechanism.bodies[body].rates_of(twist);
        let mut admitted = *twist;
        for (n, unit) in self.freedoms(body, true) {
            let arm = if n < 3 { 1.0 } else { reach };
            if arm * rates[n].abs() > ROUND_OFF * speed {
                let how = ["along x", "along y", "along z", "in yaw", "in tilt", "in spin"][n];
                return Err(format!("it is to move {how}, where the case holds it: give it a motion there"));
            }
            admitted = admitted - rates[n] * unit;
        }
        Ok(admitted)
    }

    /// Where the other program has a body, if that is near enough to where it is here.
    fn near(&self, body: usize, pose: &Pose) -> Result<Pose, String> {
        let pose = sound(pose)?;
        let now = self.state.pose(body);
        let (low, high) = self.model.bodies[body].shape.bounds();
        let turn = turn(now.rotation, pose.rotation).length();
        let apart = (pose.position - now.position).length() + turn * low.abs().max(high).length();
        let cells = apart / self.model.grid.finest();
        if cells > APART {
            return Err(format!(
                "the other program has it {apart:.2e} m from where it is here, {cells:.2} cells: exchange more often, or lead it \
                 there by a pose"
            ));
        }
        Ok(pose)
    }
}

fn finite(vectors: &[DVec3]) -> Result<(), String> {
    if vectors.iter().all(|vector| vector.is_finite()) { Ok(()) } else { Err("a number is missing".into()) }
}

/// A pose whose rotation is one.
fn sound(pose: &Pose) -> Result<Pose, String> {
    finite(&[pose.position])?;
    let length = pose.rotation.length();
    if !(0.99..1.01).contains(&length) {
        return Err(format!("its quaternion has the length {length}, and no rotation"));
    }
    Ok(Pose { position: pose.position, rotation: pose.rotation.normalize() })
}

/// The rotation vector from one attitude to another, the shorter way [rad].
fn turn(from: DQuat, to: DQuat) -> DVec3 {
    let by = to * from.inverse();
    let by = if by.w < 0.0 { -by } else { by };
    by.to_scaled_axis()
}

/// The twist that carries a body from one pose to another in these steps. A step turns it by
/// 2 arctan(½ ω Δt).
fn leading(from: &Pose, to: &Pose, Steps { number, dt, .. }: Steps) -> Result<Twist, String> {
    let to = sound(to)?;
    let turn = turn(from.rotation, to.rotation);
    let angle = turn.length();
    let lasts = number as f64 * dt;
    let each = angle / number as f64;
    let angular = if angle > 0.0 { (2.0 * (0.5 * each).tan() / (dt * angle)) * turn } else { DVec3::ZERO };
    Ok(Twist { linear: (to.position - from.position) / lasts, angular })
}
