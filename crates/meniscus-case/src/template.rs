//! The case that a new user starts from.

/// A commented case file of this title, which runs as it is.
pub fn template(name: &str) -> String {
    let title: String = name
        .chars()
        .filter(|c| !c.is_control() && !"\"\\".contains(*c))
        .collect();
    format!(
        r##"# A case of Meniscus. Every quantity has its unit; a bare number is SI.
# `meniscus check FILE` says what it means, `meniscus run FILE` runs it.
title = "{title}"
dimension = 2                     # or 3
spacing = "0.05 mm"               # distance between particles; below, "dx" is a unit of length
end_time = "20 ms"
kernel = "wendland-c2"            # or another; a wrong name lists them all
smoothing_length = "2 dx"

[fluid.water]                     # as many as you like, each with a name
density = "998 kg/m^3"
surface_tension = "72.8 mN/m"
viscosity = "1 mPa s"
# sound_speed = "5 m/s"           # default: ten times the largest speed that the case shows

[[body]]                          # as many as you like; of the only fluid, or fluid = "water"
shape = {{ ellipse = {{ semi_axes = ["1.1 mm", "0.9 mm"] }} }}
arrangement = "triangular"        # or square, rings
# velocity = ["0.1 m/s", "0 m/s"]

# Everything below is optional.
# [periodic]
# x = ["-5 mm", "5 mm"]

[physics]
artificial_viscosity = 0.1
# body_force = ["0 m/s^2", "-9.81 m/s^2"]
# time_step = "6 us"              # default: "adaptive"

[output]
frames = "0.2 ms"                 # ParaView
series = "20 us"                  # table of numbers over time
checkpoints = "5 ms"              # to resume from

[measure]
oscillation = {{ mode = 2 }}        # surface tension from the frequency of the ellipse
sensors = [{{ name = "centre", at = ["0 mm", "0 mm"] }}]
"##
    )
}
