//! Scratch: runs a case and prints.
fn main() {
    let args: Vec<String> = std::env::args().collect();
    let case = match coulter::case::load(std::path::Path::new(&args[1]), &args[2..].to_vec()) {
        Ok(c) => c,
        Err(e) => {
            println!("{:?}", miette::Report::new(e));
            return;
        }
    };
    let mut sim = coulter::simulation::Simulation::new(&case);
    println!("cells {:?} dt {:e} threads {}", sim.model.grid.cells(), sim.model.time_step(), sim.threads());
    let every = (case.duration / case.output.history_interval / 40.0).ceil() as usize;
    let mut n = 0;
    while !sim.is_done() {
        if let Err(e) = sim.advance() {
            println!("BREAKDOWN {e}");
            break;
        }
        n += 1;
        if n % every == 0 || sim.is_done() {
            let e = sim.history.energy.last().unwrap();
            for b in &sim.history.bodies {
                let b = b.last().unwrap();
                print!(
                    "t {:.3} u {:.4} z {:.4} FH {:.3} FV {:.3} T {:.4} wr/v {:.3} leak {:.2e} | ",
                    b.time,
                    b.displacement,
                    b.sinkage,
                    b.drag,
                    b.vertical,
                    b.axle_torque,
                    b.spin * 0.1 / b.speed,
                    b.leaked_volume
                );
            }
            println!(
                "ext {:.3} kin {:.2e} el {:.2e} pl {:.3} fr {:.3} vi {:.3} hg {:.4} rm {:.4} clo {:.4} vol {:.6} remaps {} steps {} wall {:.1}",
                e.external,
                e.kinetic,
                e.elastic,
                e.plastic,
                e.friction,
                e.viscous,
                e.hourglass,
                e.remap_loss,
                e.closure(),
                e.volume_ratio,
                sim.state.remaps,
                sim.state.step,
                sim.wall_s
            );
        }
    }
    let cells: usize = sim.state.soil.fraction.iter().filter(|f| **f > 0.0).count();
    println!(
        "rate {:.2} M cell-steps/s over {} filled",
        cells as f64 * sim.state.step as f64 / sim.wall_s / 1e6,
        cells
    );
}
