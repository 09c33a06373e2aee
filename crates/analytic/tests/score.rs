use analytic::disc::{Disc, Drive};
use analytic::forecast::{Candidate, Outline, Plate, predict};
use analytic::{Load, Soil, Towing};
fn soil(phi:f64,gamma:f64,mu:f64)->Soil{let a=phi.to_radians();Soil{friction_angle:a,dilation_angle:0.0,cohesion:0.0,unit_weight:gamma,body_friction:mu}}
fn run(m:Candidate,davis:bool,t:&Towing)->Option<(f64,f64,f64)>{let mut t=t.clone(); if davis{t.soil=t.soil.operative().unwrap()} predict(m,&t,None).ok().map(|p|(p.drag,p.vertical,1e3*p.sinkage.unwrap()))}
#[test] fn trial(){
 let plate=Plate{outline:Outline::Circle,width:0.08,length:0.08};
 let wheel=Disc{diameter:0.116,thickness:0.05};
 for phi in [29.0,31.0,32.0,33.0,34.0]{ for (n,m,d) in [("full",Candidate::Footing,false),("davis",Candidate::Footing,true),("rft",Candidate::SpatialResistive,false)]{
  print!("plate phi {phi} {n:6}");
  for (z,f) in [(5.,22.1),(10.,51.4),(15.,87.9),(20.,134.7),(25.,192.8)]{ let t=Towing::new(soil(phi,13030.,0.4),plate,Load::Sinkage(z*1e-3),Drive::Locked); print!(" {:.0}({f:.0})",run(m,d,&t).unwrap().1)}
  print!("  | indentation");
  for (z,f) in [(5.,4.7),(10.,19.1),(15.,37.5),(20.,67.1),(25.,99.3),(30.,142.7),(35.,195.4),(40.,246.8)]{ let mut t=Towing::new(soil(phi,13030.,0.4),wheel,Load::Sinkage(z*1e-3),Drive::Locked); t.pressed=true; print!(" {:.0}({f:.0})",run(m,d,&t).unwrap().1)}
  println!();
 }}
 // solver
 let disc=Disc{diameter:0.2,thickness:0.05};
 let rows=[("light",soil(35.,16e3,0.3),disc,Load::Weight(40.),Drive::Free,15.4,40.,16.93),("heavy",soil(35.,16e3,0.3),disc,Load::Weight(100.),Drive::Free,50.8,100.,41.0),
  ("locked",soil(32.,13030.,0.4),wheel,Load::Weight(19.5),Drive::Locked,17.5,19.5,34.5),("s=0",soil(32.,13030.,0.4),wheel,Load::Weight(24.58),Drive::Slip(0.0),6.5,24.58,17.5),("free",soil(32.,13030.,0.4),wheel,Load::Weight(24.),Drive::Free,14.0,24.,26.0),
  ("held locked",soil(32.,13030.,0.4),wheel,Load::Sinkage(0.0503),Drive::Locked,29.1,28.7,50.3),("held locked 36",soil(36.,13030.,0.4),wheel,Load::Sinkage(0.0503),Drive::Locked,42.3,41.6,50.3),("held s=0",soil(32.,13030.,0.4),wheel,Load::Sinkage(0.0144),Drive::Slip(0.),5.2,20.8,14.4)];
 for (name,s,b,l,dr,f,v,z) in rows { println!("{name}: solver {f} {v} {z}");
  for (n,m,d) in [("gov full",Candidate::Governing,false),("gov davis",Candidate::Governing,true),("BC full",Candidate::Bearing,false),("BC davis",Candidate::Bearing,true),("rft",Candidate::SpatialResistive,false)]{ let t=Towing::new(s,b,l,dr); println!("   {n:10} {:?}",run(m,d,&t)) } }
}
