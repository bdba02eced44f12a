//! The layers together, against the grasps of an independent program and the printed paper.

mod cases;
