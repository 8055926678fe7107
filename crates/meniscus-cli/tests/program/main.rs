//! The program as its user meets it: commands, files, words and exit codes.

#![cfg(unix)]

mod appraise;
mod bench;
mod calibrate;
mod commands;
mod divergence;
mod reproduce;
mod resume;
mod run;
mod workplace;
